"""The table as bars: nanoseconds an item, logarithmic, the bound as a line."""

import math

from PIL import Image, ImageDraw, ImageFont

FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
COLORS = {"splinecore": (36, 99, 174), "SISL": (226, 135, 41), "OCCT": (140, 140, 140),
           "scipy": (86, 160, 92)}
WIDTH, LEFT, RIGHT, TOP, BAR, GAP = 1200, 170, 110, 110, 16, 14


def draw(rows, machine, path):
    """Rows that have a bound; nothing where there are none."""
    path.unlink(missing_ok=True)
    font, small = ImageFont.truetype(FONT, 15), ImageFont.truetype(FONT, 12)
    bars = [(row, bars_of(row)) for row in rows if row.bound_ns and row.ours]
    if not bars:
        return
    values = [value for _, each in bars for _, value in each] + [row.bound_ns for row, _ in bars if row.bound_ns]
    low, high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
    height = TOP + sum(len(each) * BAR + GAP for _, each in bars) + 40
    image = Image.new("RGB", (WIDTH, height), "white")
    canvas = ImageDraw.Draw(image)

    def place(value):
        return LEFT + (math.log10(value) - low) / (high - low) * (WIDTH - LEFT - RIGHT)

    heading(canvas, machine, font, small)
    for power in range(low, high + 1):
        x = place(10.0**power)
        canvas.line([x, TOP - 8, x, height - 30], fill=(225, 225, 225))
        canvas.text((x, height - 26), f"{10.0**power:g} ns", fill="black", font=small, anchor="ma")
    y = TOP
    for row, each in bars:
        canvas.text((LEFT - 12, y + len(each) * BAR / 2), row.workload, fill="black", font=font, anchor="rm")
        for who, value in each:
            canvas.rectangle([LEFT, y + 1, place(value), y + BAR - 2], fill=COLORS[who])
            text = f"{value:.3g}" + (f"   {row.ratio:.1f}×" if who == "splinecore" and row.ratio else "")
            canvas.text((place(value) + 5, y + BAR / 2), text, fill="black", font=small, anchor="lm")
            y += BAR
        if row.bound_ns:
            x = place(row.bound_ns)
            canvas.line([x, y - len(each) * BAR, x, y], fill=(200, 30, 30), width=2)
        y += GAP
    image.save(path)


def heading(canvas, machine, font, small):
    canvas.text((20, 16), "Nanoseconds an item, one thread", fill="black", font=font)
    canvas.text((20, 40), f"{machine['name']}; {machine['versions']}", fill=(90, 90, 90), font=small)
    x = 20
    for who, color in [*COLORS.items(), ("the physical bound", (200, 30, 30))]:
        canvas.rectangle([x, 68, x + 12, 80], fill=color)
        canvas.text((x + 18, 74), who, fill="black", font=small, anchor="lm")
        x += 50 + 8 * len(who)


def bars_of(row):
    """(who, ns): ours, and of each rival the call that the table shows or its fastest."""
    bars = [("splinecore", row.calls[row.ours])]
    for who in ("SISL", "OCCT"):
        calls = {name: ns for name, ns in row.calls.items() if name.startswith(who)}
        if row.rival in calls:
            bars.append((who, calls[row.rival]))
        elif calls:
            bars.append((who, min(calls.values())))
    return bars
