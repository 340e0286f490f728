/**
 * Episodes of programs that learn: one world, started again and again, stepped by the thread that calls, with what is observed as numbers, and its
 * plan as a picture. Uses {@link org.SEAR.plan}, and what that uses. No threads of its own; one thread at a time.
 */
package org.SEAR.learning;
