package org.SEAR.sensors;

/** What an odometer has counted since it was last cleared. Immutable. */
public final class OdometerReading implements Reading {
    private static final int DIGITS = 3;

    private final int millimetres;
    private final boolean valid;

    OdometerReading(int millimetres, boolean valid) {
        this.millimetres = millimetres;
        this.valid = valid;
    }

    /** -32768 to 32767, + forward; 0 when the reading dropped out. */
    public int getMillimetres() {
        return millimetres;
    }

    /** The same in metres, -32.768 to 32.767; NaN when the reading dropped out. */
    public double getMetres() {
        return valid ? millimetres / 1000.0 : Double.NaN;
    }

    /** Whether there was a reading. */
    public boolean isValid() {
        return valid;
    }

    /** In metres. */
    @Override
    public double[] numbers() {
        return new double[] {getMetres()};
    }

    @Override
    public String words(double[] kept, String unit) {
        return ReadingWords.withUnit(ReadingWords.fixed(kept, DIGITS), unit);
    }

    @Override
    public String toString() {
        return getMetres() + " m";
    }
}
