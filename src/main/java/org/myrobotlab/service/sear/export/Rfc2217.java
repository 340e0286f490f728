// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.export;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.function.Consumer;
import org.myrobotlab.serial.VirtualSerialPort;

/**
 * The access server's side of RFC 2217: a Telnet connection whose Com Port Control option (44) sets the line's baud
 * rate. The line is always 8N1 without handshake and reports so to any request. DTR and RTS are acknowledged without
 * effect. Stores at most {@link #MAX_SUBNEGOTIATION} bytes. Call {@link #received} on one thread, {@link #encode} on
 * any.
 *
 * <pre>
 * FF FA 2C 01 00 00 25 80 FF F0      program: SET-BAUDRATE 9600
 * FF FA 2C 65 00 00 25 80 FF F0      answer: the same, command + 100
 * </pre>
 */
final class Rfc2217 implements TcpSession {
    /** Creates sessions of this kind. */
    static final Kind KIND = new Kind() {
        @Override
        public TcpSession begin(LineEnd end, Consumer<byte[]> replies) {
            return new Rfc2217(end, replies);
        }

        @Override
        public String getName() {
            return "rfc2217";
        }
    };

    /** Most stored bytes of a subnegotiation; more than any command has. */
    static final int MAX_SUBNEGOTIATION = 64;
    /** Number of bytes without negotiation that identify a program without RFC 2217. */
    private static final int RAW = 10;
    private static final int BYTE = 0xFF;
    private static final int IAC = 255;
    private static final int DONT = 254;
    private static final int DO = 253;
    private static final int WONT = 252;
    private static final int WILL = 251;
    private static final int SB = 250;
    private static final int SE = 240;
    private static final int OPTION_BINARY = 0;
    private static final int OPTION_SUPPRESS_GO_AHEAD = 3;
    private static final int OPTION_COM_PORT = 44;
    private static final int OPTIONS = 256;
    private static final int ANSWER = 100;
    private static final int SIGNATURE = 0;
    private static final int SET_BAUDRATE = 1;
    private static final int SET_DATASIZE = 2;
    private static final int SET_PARITY = 3;
    private static final int SET_STOPSIZE = 4;
    private static final int SET_CONTROL = 5;
    private static final int SET_LINESTATE_MASK = 10;
    private static final int SET_MODEMSTATE_MASK = 11;
    private static final int PURGE_DATA = 12;
    private static final int NOTIFY_MODEMSTATE = 107;
    private static final int EIGHT_BITS = 8;
    private static final int NO_PARITY = 1;
    private static final int ONE_STOP_BIT = 1;
    /** CD, DSR and CTS are on, as with a bridged cable. */
    private static final int MODEM_READY = 0xB0;

    /** State of the Telnet parser before the next byte. */
    private enum State { DATA, COMMAND, OPTION, SUBNEGOTIATION, SUBNEGOTIATION_COMMAND }

    private final LineEnd end;
    private final Consumer<byte[]> replies;
    private final boolean[] ours = new boolean[OPTIONS];
    private final boolean[] theirs = new boolean[OPTIONS];
    private final byte[] subnegotiation = new byte[MAX_SUBNEGOTIATION];
    private final LineControl control = new LineControl();
    private boolean negotiated;
    private int raw;
    private int length;
    private State state = State.DATA;
    private int command;

    /** @param replies takes the replies to the program */
    Rfc2217(LineEnd end, Consumer<byte[]> replies) {
        this.end = end;
        this.replies = replies;
    }

    @Override
    public void received(byte[] bytes) {
        ByteArrayOutputStream data = new ByteArrayOutputStream();
        for (byte one : bytes) {
            if (accept(one & BYTE)) {
                data.write(one);
            } else if (state != State.DATA) {
                flush(data);
            }
        }
        flush(data);
    }

    /** Sends the data before a command, so that it precedes the command's effect. */
    private void flush(ByteArrayOutputStream data) {
        if (data.size() > 0) {
            raw += negotiated ? 0 : data.size();
            if (raw >= RAW) {
                negotiated = true;
                end.warn("raw", raw + " bytes arrived without RFC 2217 negotiation: is it the right port? A program "
                    + "that sends raw bytes needs exportTcp");
            }
            end.send(data.toByteArray());
            data.reset();
        }
    }

    /** @return whether the byte is for the device */
    private boolean accept(int value) {
        switch (state) {
            case DATA:
                state = value == IAC ? State.COMMAND : State.DATA;
                return value != IAC;
            case COMMAND:
                return onCommand(value);
            case OPTION:
                state = State.DATA;
                negotiate(value);
                return false;
            case SUBNEGOTIATION:
                if (value == IAC) {
                    state = State.SUBNEGOTIATION_COMMAND;
                } else {
                    keep(value);
                }
                return false;
            default:
                onSubnegotiationCommand(value);
                return false;
        }
    }

    private boolean onCommand(int value) {
        negotiated = true;
        command = value;
        length = 0;
        if (value >= WILL && value <= DONT) {
            state = State.OPTION;
        } else {
            state = value == SB ? State.SUBNEGOTIATION : State.DATA;
        }
        return value == IAC;
    }

    private void onSubnegotiationCommand(int value) {
        if (value == IAC) {
            keep(value);
            state = State.SUBNEGOTIATION;
        } else {
            state = State.DATA;
            if (value == SE && length <= MAX_SUBNEGOTIATION) {
                execute();
            }
        }
    }

    /** Stores a byte; beyond the limit only marks the subnegotiation as too long to be a command. */
    private void keep(int value) {
        if (length < MAX_SUBNEGOTIATION) {
            subnegotiation[length] = (byte) value;
        }
        length = Math.min(length + 1, MAX_SUBNEGOTIATION + 1);
    }

    /** Answers only requests that change something, so that two sides never answer each other forever (RFC 854). */
    private void negotiate(int option) {
        boolean known = option == OPTION_BINARY || option == OPTION_SUPPRESS_GO_AHEAD || option == OPTION_COM_PORT;
        boolean on = command == DO || command == WILL;
        boolean[] side = command == DO || command == DONT ? ours : theirs;
        boolean aboutUs = side == ours;
        if (on && !known) {
            answer(aboutUs ? WONT : DONT, option);
        } else if (on != side[option]) {
            side[option] = on;
            answer(aboutUs ? on ? WILL : WONT : on ? DO : DONT, option);
            if (option == OPTION_COM_PORT && command == WILL) {
                report(NOTIFY_MODEMSTATE, MODEM_READY);
            }
        }
    }

    private void answer(int verb, int option) {
        replies.accept(new byte[] {(byte) IAC, (byte) verb, (byte) option});
    }

    private void execute() {
        if (length < 2 || (subnegotiation[0] & BYTE) != OPTION_COM_PORT) {
            return;
        }
        int code = subnegotiation[1] & BYTE;
        if (code == SIGNATURE) {
            if (length == 2) {
                report(SIGNATURE + ANSWER, 'S', 'E', 'A', 'R');
            }
        } else if (code == SET_BAUDRATE && length == 2 + Integer.BYTES) {
            setBaud(ByteBuffer.wrap(subnegotiation, 2, Integer.BYTES).getInt());
        } else if (length == 2 + 1) {
            set(code, subnegotiation[2] & BYTE);
        }
    }

    /** Sets the rate and reports the one in force; 0 only queries, and invalid rates change nothing. */
    private void setBaud(int wanted) {
        if (wanted >= VirtualSerialPort.LOWEST_BAUD && wanted <= VirtualSerialPort.HIGHEST_BAUD) {
            end.setBaud(wanted);
        }
        byte[] baud = ByteBuffer.allocate(Integer.BYTES).putInt(end.getLineBaud()).array();
        report(SET_BAUDRATE + ANSWER, baud[0] & BYTE, baud[1] & BYTE, baud[2] & BYTE, baud[3] & BYTE);
    }

    private void set(int code, int value) {
        switch (code) {
            case SET_DATASIZE:
                report(code + ANSWER, EIGHT_BITS);
                break;
            case SET_PARITY:
                report(code + ANSWER, NO_PARITY);
                break;
            case SET_STOPSIZE:
                report(code + ANSWER, ONE_STOP_BIT);
                break;
            case SET_CONTROL:
                report(code + ANSWER, control.set(value));
                break;
            case SET_MODEMSTATE_MASK:
                report(code + ANSWER, value);
                report(NOTIFY_MODEMSTATE, MODEM_READY & value);
                break;
            case SET_LINESTATE_MASK:
            case PURGE_DATA:
                report(code + ANSWER, value);
                break;
            default:
                break;
        }
    }

    /** Sends a command of the option. */
    private void report(int code, int... values) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.write(IAC);
        out.write(SB);
        out.write(OPTION_COM_PORT);
        out.write(code);
        for (int value : values) {
            writeEscaped(value, out);
        }
        out.write(IAC);
        out.write(SE);
        replies.accept(out.toByteArray());
    }

    private static void writeEscaped(int value, ByteArrayOutputStream out) {
        out.write(value);
        if ((value & BYTE) == IAC) {
            out.write(value);
        }
    }

    @Override
    public byte[] encode(byte[] fromDevice) {
        ByteArrayOutputStream out = new ByteArrayOutputStream(fromDevice.length + 1);
        for (byte value : fromDevice) {
            writeEscaped(value, out);
        }
        return out.toByteArray();
    }
}
