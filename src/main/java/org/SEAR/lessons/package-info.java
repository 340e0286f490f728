/**
 * What a check of a lesson measures: where robots were and what they touched in a run, found by running the commands of its record again.
 * Uses {@link org.SEAR.record}, and what that uses. No threads of its own; one thread at a time.
 */
package org.SEAR.lessons;
