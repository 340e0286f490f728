package org.myrobotlab.service.sear.lockstep;

import java.util.concurrent.TimeUnit;
import org.myrobotlab.serial.SerialDeviceFactory;
import org.myrobotlab.serial.VirtualSerialPort;
import org.myrobotlab.service.sear.Host;

/** Waits until no virtual port has bytes that its listeners have not finished with, and the callbacks of scripts have run. */
public final class Quiescence {
    private static final long PATIENCE = TimeUnit.SECONDS.toMillis(5);

    private final Host host;
    private final Fence messages;
    private VirtualSerialPort complainedOf;
    private volatile long settled;

    public Quiescence(Host host, SleepingThreads sleepers) {
        this.host = host;
        messages = new Fence(host, sleepers);
    }

    /** Waits until ports and callbacks rest; looks at the callbacks only when bytes have come since the last time. */
    public void settle() throws InterruptedException {
        await();
        for (long moved = accepted(); moved != settled; moved = accepted()) {
            settled = moved;
            messages.await();
            await();
        }
    }

    /** Learns who deals with callbacks, before there are any. */
    public void greet() {
        messages.greet();
    }

    /** Something else has made callbacks run: the next {@link #settle} looks at them. */
    public void disturb() {
        settled = -1;
    }

    private static long accepted() {
        long sum = 0;
        for (VirtualSerialPort port : SerialDeviceFactory.getVirtualPorts()) {
            sum += port.getAccepted();
        }
        return sum;
    }

    /** Gives up on a port after some seconds, with one warning: its listener hangs. */
    private void await() throws InterruptedException {
        boolean moved = true;
        while (moved) {
            moved = false;
            for (VirtualSerialPort port : SerialDeviceFactory.getVirtualPorts()) {
                if (port.getPending() > 0 && port != complainedOf) {
                    if (port.awaitHanded(PATIENCE)) {
                        moved = true;
                    } else {
                        complain(port);
                    }
                }
            }
        }
    }

    private void complain(VirtualSerialPort port) {
        complainedOf = port;
        host.warn("a listener of port " + port.getName() + " has not finished with " + port.getPending() + " bytes within " + PATIENCE / 1000
            + " s: lock-step goes on without it");
    }
}
