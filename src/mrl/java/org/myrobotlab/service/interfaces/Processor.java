package org.myrobotlab.service.interfaces;

/** Carries out scripts. */
public interface Processor {
    /** Runs code; whether it ended well. */
    boolean exec(String code);
}
