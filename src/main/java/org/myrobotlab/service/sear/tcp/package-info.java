/** TCP ports that only programs of this computer reach. */
package org.myrobotlab.service.sear.tcp;
