/**
 * Waiting until bytes and messages have been dealt with, so that in lock-step a script's callbacks have run before time goes on. May use the
 * embedded or real MyRobotLab's queues and ports. The thread that makes time pass waits here.
 */
package org.myrobotlab.service.sear.lockstep;
