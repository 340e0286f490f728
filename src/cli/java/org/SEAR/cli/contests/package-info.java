/**
 * Contests: one simulation in which each script drives a robot of its own, a referee, and the scoreboard. May use everything. The main thread,
 * one for each script and one for the referee; only one of them goes on at a time.
 */
package org.SEAR.cli.contests;
