// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.Collection;
import java.util.List;
import java.util.function.Supplier;
import org.SEAR.grammar.ParameterTable;

/**
 * A store for temporary objects. While a draft's work runs, SEAR checks the objects that its thread creates, but
 * neither writes them nor reports notices about them.
 */
public final class Draft implements ObjectStore {
    private final List<String> beamNames;

    private final Collection<String> taken;

    private Draft(List<String> beamNames, Collection<String> taken) {
        this.beamNames = beamNames;
        this.taken = taken;
    }

    /**
     * Runs work with objects that belong to no project.
     *
     * @param beamNames names of the beams available to them
     * @param work creates and changes objects; they must not be changed afterwards
     */
    public static <T> T of(List<String> beamNames, Supplier<T> work) {
        return ObjectStores.with(new Draft(beamNames, List.of()), work);
    }

    /**
     * Creates a ready robot that belongs to no project.
     *
     * @param taken names that its parts must not have, case-insensitive
     */
    public static SEARrobot robot(Collection<String> taken, Supplier<SEARrobot> work) {
        return ObjectStores.with(new Draft(List.of(), taken), work);
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
    public boolean keeps(String file, boolean part) {
        return true;
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
    public <T> T whole(Supplier<T> maker) {
        return maker.get();
    }

    @Override
    public String partName(String robot, String part) {
        return taken.stream().anyMatch(part::equalsIgnoreCase) ? robot + " " + part : part;
    }

    @Override
    public Integer orderOfRobot(String name) {
        return null;
    }

    @Override
    public Beam beam(String name) {
        if (!beamNames.contains(name)) {
            throw new IllegalArgumentException("beam is " + ParameterTable.quote(name) + ", legal: "
                + String.join(", ", beamNames));
        }
        return new Beam();
    }

    @Override
    public List<String> beamNames() {
        return beamNames;
    }
}
