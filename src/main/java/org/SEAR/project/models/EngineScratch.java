package org.SEAR.project.models;

import com.jme3.util.TempVars;
import java.util.ArrayList;
import java.util.List;

/**
 * jMonkeyEngine's scratch variables of the calling thread. Its loaders take one and don't give it back when they fail; after five such failures the
 * thread could load no model any more. For use by the thread that made it.
 */
final class EngineScratch {
    private final List<TempVars> free = new ArrayList<>();

    /** Looks which are free now. */
    EngineScratch() {
        try {
            while (true) {
                free.add(TempVars.get());
            }
        } catch (ArrayIndexOutOfBoundsException e) {
            // that was the last one
            giveBack();
        }
    }

    /** Gives those back that were free and are not. */
    void giveBack() {
        for (int i = free.size() - 1; i >= 0; i--) {
            try {
                free.get(i).release();
            } catch (IllegalStateException e) {
                // it is free
                continue;
            }
        }
    }
}
