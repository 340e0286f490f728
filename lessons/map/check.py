# Check: compares map.txt with the room. A character counts as right if it fits its cell or an adjacent one.
SECONDS = 120
SIZE = 42
CRATES = ((1, 1, 0.4, 0.8), (-1.1, -1, 0.6, 0.4), (0, 1.2, 0.4, 0.4))    # x, z, length, width
FOUND, WRONG, FREE = 0.9, 0.05, 0.85

def isThere(row, column):
    x, z = 2.05 - row * 0.1, column * 0.1 - 2.05
    return max(abs(x), abs(z)) > 2 or any(abs(x - cx) < length / 2 and abs(z - cz) < width / 2 for cx, cz, length, width in CRATES)

def around(row, column):
    return [(r, c) for r in (row - 1, row, row + 1) for c in (column - 1, column, column + 1) if 0 <= r < SIZE and 0 <= c < SIZE]

def check(run):
    robot = run.robot
    text = run.file("map.txt")
    run.need(text is not None, "There is no file map.txt, or it is larger than a megabyte.")
    run.need(text is None or "#" in text, "map.txt has no #, where a wall is.")
    run.ask(not robot.bumps, "You bumped into something, %d times; the first time after %.1f s." % (len(robot.bumps), (list(robot.bumps) + [0])[0]))
    if text is None:
        return
    grid = text.split()
    if not run.ask(len(grid) == SIZE and all(len(line) == SIZE for line in grid),
                   "map.txt has %d lines, the first of %d signs; %d lines of %d signs are asked." % (len(grid), len((grid + [""])[0]), SIZE, SIZE)):
        return
    cells = [(row, column) for row in range(SIZE) for column in range(SIZE)]
    faces = [cell for cell in cells if isThere(*cell) and any(not isThere(*other) for other in around(*cell))]
    found = sum(1 for cell in faces if any(grid[r][c] == "#" for r, c in around(*cell))) / float(len(faces))
    run.ask(found >= FOUND, "Of the sides of walls and crates %.0f %% are in your map; %.0f %% are asked. Drive to where the others can be seen."
            % (100 * found, 100 * FOUND))
    marked = [cell for cell in cells if grid[cell[0]][cell[1]] == "#"]
    wrong = sum(1 for cell in marked if not any(isThere(*other) for other in around(*cell))) / float(max(1, len(marked)))
    run.ask(wrong <= WRONG, "Of your # there are %.0f %% where nothing is; %.0f %% are allowed." % (100 * wrong, 100 * WRONG))
    empty = [cell for cell in cells if not isThere(*cell)]
    free = sum(1 for row, column in empty if grid[row][column] == ".") / float(len(empty))
    run.ask(free >= FREE, "Of the free floor %.0f %% is . in your map; %.0f %% is asked." % (100 * free, 100 * FREE))
    run.measure("walls found", found)
    run.measure("floor found", free)
