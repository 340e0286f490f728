package org.myrobotlab.service.sear.lockstep;

/** A service that carries out callbacks on a thread of its own, behind its messages, and {@link FencePass passes} with them. Any thread. */
public interface CallbackService {
    /** That thread; null before the first callback. */
    Thread getCallbackThread();
}
