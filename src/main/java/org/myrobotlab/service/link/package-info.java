/** What the services share: a serial line with time-outs, panel files on the disk, warnings. May use {@link org.myrobotlab.serial}. Any thread. */
package org.myrobotlab.service.link;
