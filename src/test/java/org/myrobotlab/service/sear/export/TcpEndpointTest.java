// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.export;

import static org.junit.Assert.assertEquals;

import java.net.Socket;
import java.util.concurrent.TimeUnit;
import org.junit.Test;
import org.myrobotlab.service.sear.RecordingHost;

/** A TCP export with programs that leave at any moment. */
public class TcpEndpointTest {
    private static final int PROGRAMS = 1000;
    private static final int PATIENCE_MILLIS = (int) TimeUnit.MINUTES.toMillis(2);
    private static final byte SENT = 7;

    private volatile boolean done;

    /** The device's thread closes a lost connection while the server's thread handles its key. */
    @Test
    public void programsThatLeaveWhileTheDeviceSendsDoNotEndTheServer() throws Exception {
        TcpEndpoint endpoint = TcpEndpoint.open("/dev/port", TcpSession.RAW, 0);
        PortBridge bridge = new PortBridge("/dev/port", new RecordingHost());
        bridge.add(endpoint);
        Thread device = new Thread(() -> {
            while (!done) {
                endpoint.write(new byte[] {SENT}, new int[1]);
            }
        });
        device.start();
        try {
            for (int i = 0; i < PROGRAMS; i++) {
                Socket program = new Socket("127.0.0.1", endpoint.getNumber());
                program.getOutputStream().write(SENT);
                program.setSoLinger(i % 2 == 0, 0);
                program.close();
            }
            try (Socket last = new Socket("127.0.0.1", endpoint.getNumber())) {
                last.setSoTimeout(PATIENCE_MILLIS);
                assertEquals(SENT, last.getInputStream().read());
            }
        } finally {
            done = true;
            device.join();
            bridge.close();
        }
    }
}
