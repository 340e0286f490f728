/**
 * Several threads for one piece of work, and the same result as from one. Uses nothing of SEAR. Everything here is called on one thread at a time,
 * which gets its results back before it goes on.
 */
package org.SEAR.parallel;
