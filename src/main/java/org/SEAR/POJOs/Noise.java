// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;

/** Error model of a sensor, in the unit of its reading. All parameters default to 0. One thread at a time. */
@Described("the error model of a sensor")
public class Noise {
    @Param(doc = "standard deviation of the white noise", unit = "unit of the reading")
    private double white;
    @Param(doc = "constant error", unit = "unit of the reading", min = -1e6)
    private double bias;
    @Param(doc = "random walk of the error", unit = "unit of the reading per square root of a second")
    private double drift;
    @Param(doc = "step size of the reading; 0 for none", unit = "unit of the reading")
    private double quantisation;
    @Param(doc = "probability of a missing reading", max = 1)
    private double dropout;
    private SensorObject owner;

    /** Without errors. */
    public Noise() {
    }

    /** @param white standard deviation of the white noise */
    public Noise(double white) {
        this(white, 0, 0, 0, 0);
    }

    /** With all parameters. */
    public Noise(double white, double bias, double drift, double quantisation, double dropout) {
        this.white = checked("white", white);
        this.bias = checked("bias", bias);
        this.drift = checked("drift", drift);
        this.quantisation = checked("quantisation", quantisation);
        this.dropout = checked("dropout", dropout);
    }

    void setOwner(SensorObject newOwner) {
        owner = newOwner;
    }

    private double checked(String element, double value) {
        if (owner != null) {
            owner.checkChangeable();
        }
        Parameter parameter = ParameterTable.of(Noise.class).get(element);
        if (!parameter.isLegal(value)) {
            throw new IllegalArgumentException("Noise" + (owner == null ? "" : " of " + owner.label()) + ": "
                + element + " is " + Parameter.format(value) + ", legal: " + parameter.legal());
        }
        return value + 0.0;
    }

    private Noise changed() {
        if (owner != null) {
            owner.changed();
        }
        return this;
    }

    public double getWhite() {
        return white;
    }

    public double getBias() {
        return bias;
    }

    public double getDrift() {
        return drift;
    }

    public double getQuantisation() {
        return quantisation;
    }

    public double getDropout() {
        return dropout;
    }

    /** @param value 0 to 1e6 */
    public Noise setWhite(double value) {
        white = checked("white", value);
        return changed();
    }

    /** @param value -1e6 to 1e6 */
    public Noise setBias(double value) {
        bias = checked("bias", value);
        return changed();
    }

    /** @param value 0 to 1e6 */
    public Noise setDrift(double value) {
        drift = checked("drift", value);
        return changed();
    }

    /** @param value 0 to 1e6 */
    public Noise setQuantisation(double value) {
        quantisation = checked("quantisation", value);
        return changed();
    }

    /** @param value 0 to 1 */
    public Noise setDropout(double value) {
        dropout = checked("dropout", value);
        return changed();
    }
}
