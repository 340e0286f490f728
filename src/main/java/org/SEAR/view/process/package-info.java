/**
 * The same link between two processes, where the window has one of its own: what travels through the pipes, and how. Uses
 * {@link org.SEAR.view.link}, and what that uses. A thread reads each pipe; anybody may write.
 */
package org.SEAR.view.process;
