/** MyRobotLab's own: names and JSON of messages, as far as scripts and services use them. Any thread. */
package org.myrobotlab.codec;
