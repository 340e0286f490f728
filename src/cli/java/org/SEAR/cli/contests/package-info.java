/**
 * Contests: one simulation in which each script drives a robot of its own, a referee, and the scoreboard. May use everything. The main thread, and
 * one for each script; only one of them goes on at a time.
 */
package org.SEAR.cli.contests;
