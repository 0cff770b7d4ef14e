#include "tessellate/cell_grid.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("stopped") {}
};

/// A rectangle of so many rows, cut into them.
void cut_into_rows(Place count, std::vector<Cut>& cuts) {
  if (count > 1) {
    cuts.push_back(Cut::across_v);
    cut_into_rows(count / 2, cuts);
    cut_into_rows(count / 2, cuts);
  } else {
    cuts.push_back(Cut::none);
  }
}

/// One tall cell beside a column of many.
CellGrid tall_beside_low(Place count) {
  std::vector<std::vector<Cut>> rows{{Cut::none}, {}};
  cut_into_rows(count, rows[1]);
  return CellGrid({0, 1, 2}, {0, count}, rows);
}

}  // namespace

TEST(CellGrid, CellsShareTheVerticesBetweenThem) {
  // Four cells around a vertex, which both halves of the cut across u have.
  const std::vector<std::vector<Cut>> rows{
      {Cut::across_u, Cut::across_v, Cut::none, Cut::none, Cut::across_v, Cut::none, Cut::none}};
  const CellGrid grid({0, 8}, {0, 8}, rows);
  ASSERT_EQ(grid.cells().size(), 4u);
  EXPECT_EQ(grid.inner_count(), 1u);
  EXPECT_EQ(grid.cells()[0].range, (MeshCell{0, 4, 0, 4}));
  EXPECT_EQ(grid.cells()[3].range, (MeshCell{4, 8, 4, 8}));
  EXPECT_EQ(grid.cells()[0].corners, (std::array<std::int32_t, 4>{-1, -1, 0, -1}));
  EXPECT_EQ(grid.cells()[1].corners, (std::array<std::int32_t, 4>{-1, 0, -1, -1}));
  EXPECT_EQ(grid.cells()[2].corners, (std::array<std::int32_t, 4>{-1, -1, -1, 0}));
  EXPECT_EQ(grid.cells()[3].corners, (std::array<std::int32_t, 4>{0, -1, -1, -1}));
}

TEST(CellGrid, ACellHasNoMoreThanOneVertexInsideASide) {
  CellGrid grid = tall_beside_low(8);
  EXPECT_EQ(grid.cells().size(), 9u);
  grid.balance();
  EXPECT_EQ(grid.cells().size(), 8u + 4u);
  for (const GridCell& cell : grid.cells()) {
    const std::int32_t line = cell.lines[1];
    if (cell.range.u0 == 0) {
      EXPECT_GE(grid.middle_of(line), 0);
    }
  }
}

TEST(CellGrid, AVertexOnTheBorderIsThereOnceAndSplitsWhereThereIsAnother) {
  CellGrid grid({0, 64}, {0, 64}, std::vector<std::vector<Cut>>{{Cut::none}});
  EXPECT_TRUE(grid.add(1, 3));
  EXPECT_FALSE(grid.add(1, 3));
  grid.balance();
  EXPECT_EQ(grid.cells().size(), 1u);
  EXPECT_TRUE(grid.add(1, 5));
  grid.balance();
  std::vector<Place> found;
  grid.on_border(1, 0, 64, found);
  EXPECT_EQ(found, (std::vector<Place>{3, 4, 5, 8, 16, 32}));
}

TEST(CellGrid, FittingItsCellsToOneAnotherPauses) {
  constexpr Place kCount = Place{1} << 16;
  CellGrid grid = tall_beside_low(kCount);
  int pauses = 0;
  {
    const Pause pause = [&] { ++pauses; };
    const Pausing pausing(pause);
    grid.balance();
  }
  EXPECT_GE(pauses, 2);
  EXPECT_EQ(grid.cells().size(), std::size_t{kCount} + kCount / 2);
  CellGrid other = tall_beside_low(kCount);
  const Pause stop = [] { throw Stopped(); };
  const Pausing pausing(stop);
  EXPECT_THROW(other.balance(), Stopped);
}

}  // namespace splinecore
