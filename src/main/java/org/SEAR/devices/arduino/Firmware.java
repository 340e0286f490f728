package org.SEAR.devices.arduino;

/** A program on the board. It sees pins and its serial line, nothing else. Simulation thread; times are simulated seconds. */
interface Firmware {
    /**
     * Its start after power-on or a reset, all pins inputs.
     *
     * @param silent whether it started long ago, so that whatever it says then has been said
     */
    void setUp(double time, boolean silent);

    /** @param value 0 to 255 */
    void receive(int value, double time);

    /** Its loop, up to a time. */
    void advance(double time);

    /** See {@link org.SEAR.devices.SerialDevice#answersAtOnce}. */
    default boolean answersAtOnce() {
        return false;
    }

    /** Has just started and says at once, too, what it otherwise says by itself a little later; where it {@link #answersAtOnce}. */
    default void introduce() {
    }

    /** What it is doing, in words for people. */
    String status();

    /** What a program can reach of its board. */
    interface Host {
        /** Its pins. */
        Pins pins();

        /** Puts bytes on the serial line. */
        void send(byte[] bytes, double time);

        /** A command came that the program knows, and that another device's bytes don't look like. */
        void understood();

        /** Bits a second of the line. */
        int getBaud();

        /** When the last byte that was sent has left the line. */
        double lineFreeAt();

        /** The program does nothing else until then; bytes that come meanwhile wait in the board's buffer, the last of more than 64 are lost. */
        void busy(double until);

        /** Something the user should know. */
        void warn(String cause, String message);
    }
}
