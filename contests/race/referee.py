# The race: first to the east end of the hall, with few bumps.
SECONDS = 90
STARTS = ((0.6, 0, 90), (-0.6, 0, 90))      # x, z, heading
GOAL = 5.5                                  # z
BUMPS = 5

def positions(contest):
    for entry, (x, z, heading) in zip(contest.entries, STARTS):
        entry.place(x, z, heading)

def stepped(contest):
    for entry in contest.entries:
        if entry.driving and entry.z >= GOAL:
            entry.points = 10 - entry.bumps
            entry.finish("reached the end of the hall")
        elif entry.bumps > BUMPS:
            entry.disqualify("more than %d bumps" % BUMPS)

def finished(contest):
    for entry in contest.entries:
        if entry.z < GOAL:
            entry.points = max(0, int(entry.z))     # a point for each metre
