package org.myrobotlab.service.sear.export;

import java.util.function.Consumer;

/** What the bytes on one TCP connection mean. One thread at a time for each direction. */
interface TcpSession {
    /** Takes bytes from the program; may wait while the line is full. */
    void received(byte[] bytes);

    /** The bytes for the program that stand for the device's. */
    byte[] encode(byte[] fromDevice);

    /** Makes the sessions of an export, one for each connection. */
    interface Kind {
        /** @param replies takes bytes for the program that don't come from the device */
        TcpSession begin(LineEnd end, Consumer<byte[]> replies);

        /** What it is called, for example {@code "tcp"}. */
        String getName();
    }

    /** The device's bytes and nothing else. */
    Kind RAW = new Kind() {
        @Override
        public TcpSession begin(LineEnd end, Consumer<byte[]> replies) {
            return new TcpSession() {
                @Override
                public void received(byte[] bytes) {
                    end.send(bytes);
                }

                @Override
                public byte[] encode(byte[] fromDevice) {
                    return fromDevice;
                }
            };
        }

        @Override
        public String getName() {
            return "tcp";
        }
    };
}
