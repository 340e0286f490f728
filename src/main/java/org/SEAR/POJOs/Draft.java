package org.SEAR.POJOs;

import java.util.List;
import java.util.function.Supplier;

/** Objects that are made only to be looked at: while a draft's work runs, what its thread makes is checked, but neither written nor told. */
public final class Draft implements ObjectStore {
    private final List<String> beamNames;

    private Draft(List<String> beamNames) {
        this.beamNames = beamNames;
    }

    /**
     * Does something with objects that belong to no project.
     *
     * @param beamNames names of the beams that there are for them
     * @param work makes and changes objects, none of which may be changed later
     */
    public static <T> T of(List<String> beamNames, Supplier<T> work) {
        return Stores.with(new Draft(beamNames), work);
    }

    @Override
    public void write(SearObject object, boolean part) {
        // a draft has no file
    }

    @Override
    public boolean replaces(String name) {
        return false;
    }

    @Override
    public void remove(String file, boolean part) {
        // a draft has no file
    }

    @Override
    public void removeOwn(SearObject part) {
        // a draft has no file
    }

    @Override
    public Integer orderOfRobot(String name) {
        return null;
    }

    @Override
    public Beam beam(String name) {
        if (!beamNames.contains(name)) {
            throw new IllegalArgumentException("beam is " + ParameterTable.quote(name) + ", legal: " + String.join(", ", beamNames));
        }
        return new Beam();
    }

    @Override
    public List<String> beamNames() {
        return beamNames;
    }
}
