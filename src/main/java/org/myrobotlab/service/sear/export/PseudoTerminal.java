// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.export;

import com.sun.jna.Library;
import com.sun.jna.Memory;
import com.sun.jna.Native;
import com.sun.jna.NativeLong;
import com.sun.jna.Platform;
import com.sun.jna.Pointer;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A pseudo-terminal in raw mode, which programs open and close like a serial port. Drops bytes while no program has it
 * open, and unread bytes when a program closes it, as a real port does. If a program pauses until the system's buffer
 * is full, an {@link Outbox} drops whole messages. Linux and macOS. macOS forgets the settings of
 * a closed terminal, so SEAR keeps the terminal side open there, and a program may read up to 4 kB of old bytes.
 */
final class PseudoTerminal implements ExternalEndpoint {
    private static final Logger log = LoggerFactory.getLogger(PseudoTerminal.class);
    private static final int READ_WRITE = 2;
    private static final int NO_CONTROLLING_TERMINAL = Platform.isMac() ? 0x20000 : 0x100;
    private static final int NOT_BLOCKING = Platform.isMac() ? 0x4 : 0x800;
    private static final int SET_FLAGS = 4;
    private static final int NOW = 0;
    private static final int FLUSH_INPUT = Platform.isMac() ? 1 : 0;
    private static final int TERMIOS_SIZE = 256;
    private static final int BUFFER = 4096;
    private static final int POLL_MILLIS = 100;
    /** Interval between checks of a closed terminal, milliseconds. */
    private static final int CLOSED_MILLIS = 10;
    private static final short POLL_IN = 1;
    private static final short POLL_OUT = 4;
    private static final short POLL_HANG_UP = 0x10;
    private static final int EVENTS_AT = Integer.BYTES;
    private static final int FOUND_AT = Integer.BYTES + Short.BYTES;
    /** Offset of the wake-up pipe's descriptor behind the master's. */
    private static final int WAKE_UP_AT = Long.BYTES;
    private static final int NONE = -1;
    /** Rate while the device's rate is unknown; no program sets it. */
    private static final int UNKNOWN_BAUD = 50;
    /** Baud rate codes of Linux (asm-generic/termbits.h). macOS uses the numbers themselves. */
    private static final int[][] LINUX_BAUDS = {{UNKNOWN_BAUD, 0x1}, {300, 0x7}, {600, 0x8}, {1200, 0x9}, {2400, 0xB},
        {4800, 0xC}, {9600, 0xD},
        {19200, 0xE}, {38400, 0xF}, {57600, 0x1001}, {115200, 0x1002}, {230400, 0x1003}, {460800, 0x1004},
            {500000, 0x1005}, {1000000, 0x1008}};
    /** Linux's TCGETS2: its termios2 has the rate as a number, including rates without a code (14400, 28800). */
    private static final long GET_TERMIOS_2 = 0x802C542AL;
    private static final int OUTPUT_SPEED = 40;
    /** Linux's TIOCPKT, packet mode: each read starts with a byte, 0 for data, else flags of the terminal's change. */
    private static final long PACKETS = 0x5420;
    private static final byte HAS_SET = 0x40;
    private static final int PACKET_HEADER = 1;
    /** Linux's EXTPROC, a local flag: the system reports every setting by a program, even an unchanged one. */
    private static final int TELL_SETTING = 0x10000;
    private static final int LOCAL_FLAGS = 12;
    /** ISIG, ICANON, ECHO; INLCR, IGNCR, ICRNL, IXON: processing that the system omits with {@link #TELL_SETTING}. */
    private static final int LOCAL_PROCESSING = 0xB;
    private static final int INPUT_PROCESSING = 0x5C0;

    private final String port;
    private final C c;
    private final int master;
    /** macOS: the terminal side that stays open; {@link #NONE} elsewhere. */
    private final int slave;
    private final String path;
    private final TerminalLink link;
    private final Memory writeDescriptor = new Memory(Long.BYTES);
    /** Pipe that ends the reader's wait: its reading end, then its writing end. */
    private final int[] wakeUp;
    /** Guarded by this. */
    private final Outbox outbox = new Outbox(bytes -> bytes);
    private volatile boolean open = true;
    private boolean unread;
    /** Length of the packet header in each read, bytes. */
    private final int header;
    /** Rate set by SEAR. Without reports of settings, a program that sets this same rate goes unnoticed. */
    private int ownBaud = UNKNOWN_BAUD;
    private volatile LineEnd end;
    private Thread reader;

    /** Functions of the C library. */
    interface C extends Library {
        int posix_openpt(int flags);

        int grantpt(int fd);

        int unlockpt(int fd);

        String ptsname(int fd);

        int open(String path, int flags);

        int close(int fd);

        NativeLong read(int fd, byte[] buffer, NativeLong count);

        NativeLong write(int fd, byte[] buffer, NativeLong count);

        int fcntl(int fd, int command, int value);

        int pipe(int[] ends);

        int poll(Pointer descriptors, NativeLong count, int millis);

        int tcgetattr(int fd, Pointer termios);

        int tcsetattr(int fd, int when, Pointer termios);

        int ioctl(int fd, NativeLong request, Pointer argument);

        void cfmakeraw(Pointer termios);

        NativeLong cfgetospeed(Pointer termios);

        int cfsetspeed(Pointer termios, NativeLong speed);

        int tcflush(int fd, int what);
    }

    private PseudoTerminal(String port, C c, int master, int slave, String path, TerminalLink link, int[] wakeUp) {
        this.port = port;
        this.c = c;
        this.master = master;
        this.slave = slave;
        this.path = path;
        this.link = link;
        this.wakeUp = wakeUp;
        this.header = reportSettings(true) ? PACKET_HEADER : 0;
    }

    /** @param link symbolic link to create, or null */
    static PseudoTerminal open(String port, Path link) throws IOException {
        if (!Platform.isLinux() && !Platform.isMac()) {
            throw new IOException("this system has no pseudo-terminals: use exportTcp(\"" + port + "\", 0)");
        }
        C c;
        try {
            c = Native.load("c", C.class);
        } catch (LinkageError e) {
            throw new IOException("pseudo-terminals need JNA (jna-5.19.1.jar in libraries/jar): use exportTcp, "
                + "or install it", e);
        }
        int master = c.posix_openpt(READ_WRITE | NO_CONTROLLING_TERMINAL);
        if (master < 0 || c.grantpt(master) != 0 || c.unlockpt(master) != 0) {
            closeIfOpen(c, master);
            throw new IOException("the system provides no pseudo-terminal (error " + Native.getLastError() + ")");
        }
        String path = c.ptsname(master);
        int slave = c.open(path, READ_WRITE | NO_CONTROLLING_TERMINAL);
        if (slave < 0 || c.fcntl(master, SET_FLAGS, NOT_BLOCKING) != 0) {
            closeIfOpen(c, slave);
            closeIfOpen(c, master);
            throw new IOException("the pseudo-terminal " + path + " can't be opened (error "
                + Native.getLastError() + ")");
        }
        makeRaw(c, slave);
        int kept = Platform.isMac() ? slave : NONE;
        if (kept == NONE) {
            c.close(slave);
        }
        int[] wakeUp = {NONE, NONE};
        try {
            if (c.pipe(wakeUp) != 0 || c.fcntl(wakeUp[1], SET_FLAGS, NOT_BLOCKING) != 0) {
                throw new IOException("the system provides no pipe (error " + Native.getLastError() + ")");
            }
            return new PseudoTerminal(port, c, master, kept, path, link == null ? null
                : TerminalLink.make(link, path), wakeUp);
        } catch (IOException | RuntimeException e) {
            closeIfOpen(c, wakeUp[0]);
            closeIfOpen(c, wakeUp[1]);
            closeIfOpen(c, kept);
            closeIfOpen(c, master);
            throw e;
        }
    }

    private static void closeIfOpen(C c, int fd) {
        if (fd >= 0) {
            c.close(fd);
        }
    }

    private static void makeRaw(C c, int slave) {
        Memory termios = new Memory(TERMIOS_SIZE);
        c.tcgetattr(slave, termios);
        c.cfmakeraw(termios);
        if (Platform.isLinux()) {
            termios.setInt(LOCAL_FLAGS, termios.getInt(LOCAL_FLAGS) | TELL_SETTING);
        }
        c.cfsetspeed(termios, new NativeLong(codeOf(UNKNOWN_BAUD)));
        c.tcsetattr(slave, NOW, termios);
    }

    private static int codeOf(int baud) {
        return Platform.isMac() ? baud : translated(baud, 0, 1);
    }

    /** Returns the path for programs to open. */
    String getPath() {
        return link == null ? path : link.toString();
    }

    @Override
    public String describe() {
        return "pseudo-terminal " + getPath();
    }

    /** Sets the device's rate, which programs see that don't set one. */
    @Override
    public synchronized void deviceAt(int baud) {
        Memory termios = new Memory(TERMIOS_SIZE);
        boolean free = open && baud > 0 && codeOf(baud) > 0 && (end == null || end.getBaud() == 0)
            && currentBaud(termios) == ownBaud;
        if (free) {
            reportSettings(false);
            c.tcgetattr(side(), termios);
            c.cfsetspeed(termios, new NativeLong(codeOf(baud)));
            c.tcsetattr(side(), NOW, termios);
            reportSettings(true);
            ownBaud = currentBaud(termios);
        }
    }

    /** Returns the descriptor for reading and changing settings. */
    private int side() {
        return Platform.isMac() ? slave : master;
    }

    /**
     * Linux: switches reports of programs' settings at the master. Off while SEAR changes settings itself.
     *
     * @return whether the system reports them
     */
    private boolean reportSettings(boolean on) {
        Memory wanted = new Memory(Integer.BYTES);
        wanted.setInt(0, on ? 1 : 0);
        return Platform.isLinux() && c.ioctl(master, new NativeLong(PACKETS, true), wanted) == 0;
    }

    @Override
    public void start(LineEnd lineEnd) {
        end = lineEnd;
        reader = new Thread(this::read, "pseudo-terminal of " + port);
        reader.setDaemon(true);
        reader.start();
    }

    private void read() {
        Memory descriptors = new Memory(2L * Long.BYTES);
        Memory termios = new Memory(TERMIOS_SIZE);
        byte[] buffer = new byte[BUFFER];
        boolean inUse = false;
        while (open) {
            int found = await(descriptors, buffer);
            boolean hungUp = (found & POLL_HANG_UP) != 0;
            if (!hungUp && !inUse && open) {
                end.opened();
                inUse = true;
            }
            if (!hungUp && (found & POLL_OUT) != 0) {
                sendRest();
            }
            int count = (found & POLL_IN) != 0 ? take(buffer) : 0;
            boolean set = header > 0 && count > 0 && (buffer[0] & HAS_SET) != 0;
            inUse |= reportBaud(set, termios);
            if (count > header) {
                end.send(Arrays.copyOfRange(buffer, header, count));
                inUse = true;
            } else if (count <= 0 && hungUp && open) {
                if (inUse) {
                    end.closed();
                    inUse = false;
                }
                forgetUnread();
                c.poll(null, new NativeLong(0), CLOSED_MILLIS);
            }
        }
    }

    /** Reads bytes. Excludes {@link #deviceAt}, which changes the read format for a moment. */
    private synchronized int take(byte[] buffer) {
        return open ? c.read(master, buffer, new NativeLong(buffer.length)).intValue() : 0;
    }

    /**
     * Checks the terminal's rate.
     *
     * @param set whether the system has reported a setting by a program
     * @return whether a program has set a rate, even the same one
     */
    private synchronized boolean reportBaud(boolean set, Memory termios) {
        int baud = open ? currentBaud(termios) : 0;
        boolean changed = baud > 0 && (set || baud != (end.getBaud() > 0 ? end.getBaud() : ownBaud));
        if (changed) {
            end.setBaud(baud);
        }
        if (set && open) {
            leaveProcessing(termios);
        }
        return changed;
    }

    /**
     * Returns input processing to the system for a program that wants lines or converted input. Its rate is known by
     * then.
     */
    private void leaveProcessing(Memory termios) {
        c.tcgetattr(side(), termios);
        int local = termios.getInt(LOCAL_FLAGS);
        if ((local & TELL_SETTING) != 0
            && ((local & LOCAL_PROCESSING) != 0 || (termios.getInt(0) & INPUT_PROCESSING) != 0)) {
            termios.setInt(LOCAL_FLAGS, local & ~TELL_SETTING);
            c.tcsetattr(side(), NOW, termios);
        }
    }

    /**
     * Waits for the reader's next task, at most {@link #POLL_MILLIS}.
     *
     * @return events at the master: {@link #POLL_IN}, {@link #POLL_OUT} if unsent bytes have room, and
     *     {@link #POLL_HANG_UP} while no program has the terminal open
     */
    private int await(Memory descriptors, byte[] buffer) {
        describe(descriptors, 0, master, hasRest() ? POLL_IN | POLL_OUT : POLL_IN);
        describe(descriptors, WAKE_UP_AT, wakeUp[0], POLL_IN);
        if (c.poll(descriptors, new NativeLong(2), POLL_MILLIS) <= 0) {
            return 0;
        }
        if (descriptors.getShort(WAKE_UP_AT + FOUND_AT) != 0) {
            c.read(wakeUp[0], buffer, new NativeLong(buffer.length));
        }
        return descriptors.getShort(FOUND_AT);
    }

    private static void describe(Memory descriptors, int at, int fd, int events) {
        descriptors.setInt(at, fd);
        descriptors.setShort(at + EVENTS_AT, (short) events);
        descriptors.setShort(at + FOUND_AT, (short) 0);
    }

    private synchronized boolean hasRest() {
        return !outbox.isEmpty();
    }

    /** Whether no program has the terminal open. */
    private boolean isHungUp() {
        describe(writeDescriptor, 0, master, POLL_IN);
        return c.poll(writeDescriptor, new NativeLong(1), 0) > 0
            && (writeDescriptor.getShort(FOUND_AT) & POLL_HANG_UP) != 0;
    }

    /** Drops unread bytes after the last program has closed the terminal. */
    private synchronized void forgetUnread() {
        outbox.clear();
        int side = open && unread ? c.open(path, READ_WRITE | NO_CONTROLLING_TERMINAL) : NONE;
        if (side >= 0) {
            c.tcflush(side, FLUSH_INPUT);
            c.close(side);
            unread = false;
        }
    }

    /** Returns the terminal's rate; 0 if the system doesn't report it or while a program closes the terminal. */
    private int currentBaud(Pointer termios) {
        if (Platform.isLinux() && c.ioctl(master, new NativeLong(GET_TERMIOS_2, true), termios) == 0) {
            return termios.getInt(OUTPUT_SPEED);
        }
        c.tcgetattr(side(), termios);
        int code = c.cfgetospeed(termios).intValue();
        return Platform.isMac() ? code : translated(code, 1, 0);
    }

    private static int translated(int value, int from, int to) {
        return Arrays.stream(LINUX_BAUDS).filter(known -> known[from] == value).mapToInt(known -> known[to])
            .findFirst().orElse(0);
    }

    @Override
    public void write(byte[] bytes, int[] starts) {
        int dropped;
        synchronized (this) {
            if (!open) {
                return;
            }
            if (isHungUp()) {
                outbox.clear();
                return;
            }
            outbox.flush(this::writeToMaster);
            boolean waited = !outbox.isEmpty();
            dropped = outbox.add(bytes, starts);
            outbox.flush(this::writeToMaster);
            if (!waited && !outbox.isEmpty()) {
                c.write(wakeUp[1], new byte[1], new NativeLong(1));
            }
        }
        if (dropped > 0 && slave == NONE) { // macOS does not report whether a program reads at all
            end.lost(dropped);
        }
    }

    private synchronized void sendRest() {
        if (open) {
            outbox.flush(this::writeToMaster);
        }
    }

    private synchronized int writeToMaster(byte[] bytes, int from, int count) {
        byte[] piece = from == 0 ? bytes : Arrays.copyOfRange(bytes, from, from + count);
        int written = c.write(master, piece, new NativeLong(count)).intValue();
        unread |= written > 0;
        return written;
    }

    @Override
    public void close() {
        open = false;
        try {
            if (reader != null) {
                reader.join(10L * POLL_MILLIS);
            }
            if (link != null) {
                link.remove();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (IOException e) {
            log.warn("link {} was not removed: {}", link, e.toString());
        }
        synchronized (this) {
            closeIfOpen(c, slave);
            c.close(master);
            c.close(wakeUp[0]);
            c.close(wakeUp[1]);
        }
    }
}
