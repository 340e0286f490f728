/**
 * What the services share: a serial line with time-outs, panel files on the disk, warnings. Uses {@link org.myrobotlab.serial}, and what that uses.
 * Any thread.
 */
package org.myrobotlab.service.link;
