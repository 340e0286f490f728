package org.myrobotlab.service.link;

/** A driver that tries other baud rates by itself while its device does not answer: nobody needs to be warned of a wrong one. */
public interface FindsBaudRate {
}
