// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.export;

import java.util.function.Consumer;

/** Protocol of one TCP connection. One thread at a time per direction. */
interface TcpSession {
    /** Takes bytes from the program; may wait while the line is full. */
    void received(byte[] bytes);

    /** Returns the device's bytes encoded for the program. */
    byte[] encode(byte[] fromDevice);

    /** Creates the sessions of an export, one per connection. */
    interface Kind {
        /** @param replies takes bytes for the program that don't come from the device */
        TcpSession begin(LineEnd end, Consumer<byte[]> replies);

        /** Returns the name, for example {@code "tcp"}. */
        String getName();
    }

    /** The device's bytes without a protocol. */
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
