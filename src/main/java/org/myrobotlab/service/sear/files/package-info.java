/**
 * Saving, loading and importing projects, and moving them to and from a browser. May use {@link org.myrobotlab.service.sear.run} and
 * {@link org.SEAR.project}. Any thread; one call at a time.
 */
package org.myrobotlab.service.sear.files;
