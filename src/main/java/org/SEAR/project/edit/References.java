// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;

/**
 * References by name between the parts of a robot: from a motor to its wheels, a servo to the mounted parts, a wheel to
 * its servo, a bumper to the part that presses it, an Arduino to the wired parts. The grammar marks these parameters,
 * and the parts that need them. One use for one part that is renamed or leaves its robot. Guarded by the project lock.
 */
final class References {
    /** Effect on an object or group, in ascending order. */
    private enum Effect { NONE, CHANGED, USELESS }

    private static final String LOST = " lost its ";

    private final EditDraft draft;
    private final SEARrobot robot;
    /** Parts that have left and whose names still have to be removed. */
    private final Deque<SearObject> left = new ArrayDeque<>();
    private final List<SearObject> deleted = new ArrayList<>();
    private final Set<String> lost = new LinkedHashSet<>();
    private SearObject part;
    private String old;
    /** Replacement of the old name; null to remove it. */
    private String now;

    /** @param robot the result: with the part's new name, or without the part */
    References(EditDraft draft, SEARrobot robot) {
        this.draft = draft;
        this.robot = robot;
    }

    /**
     * Replaces a part's old name in the files of the robot and its parts.
     *
     * @param renamed with its new name
     * @param oldName the part's name before
     */
    void follow(SearObject renamed, String oldName) throws IOException {
        part = renamed;
        old = oldName;
        now = renamed.getName();
        replaceEverywhere();
    }

    /**
     * Removes a part's name from the files of the robot and its parts. Parts that need it are deleted, and their names
     * removed likewise.
     */
    void forget(SearObject gone) throws IOException {
        left.add(gone);
        while (!left.isEmpty()) {
            part = left.remove();
            old = part.getName();
            now = null;
            replaceEverywhere();
        }
    }

    /** Returns the parts that were deleted because they need the removed one. */
    List<SearObject> deleted() {
        return deleted;
    }

    /** Returns the references that other objects lost, such as "servo pan lost its part eye". */
    Set<String> lost() {
        return lost;
    }

    private void replaceEverywhere() throws IOException {
        boolean changed = replace(robot) != Effect.NONE;
        for (String file : List.copyOf(robot.getComponentNames())) {
            String path = ObjectFiles.path(true, file);
            SearObject other = draft.readIfWhole(path);
            Effect effect = other == null ? Effect.NONE : replace(other);
            if (effect == Effect.CHANGED) {
                draft.write(path, other);
            } else if (effect == Effect.USELESS) {
                draft.delete(path);
                componentNames().remove(file);
                delete(other);
                changed = true;
            }
        }
        if (changed) {
            draft.write(ObjectFiles.path(true, robot.getName()), robot);
        }
    }

    @SuppressWarnings("unchecked")
    private List<Object> componentNames() {
        return (List<Object>) ParameterTable.of(SEARrobot.class).find("component").get(robot);
    }

    private void delete(SearObject useless) {
        lost.removeIf(text -> text.startsWith(called(useless) + LOST));
        deleted.add(useless);
        left.add(useless);
    }

    private Effect replace(Object holder) {
        Effect effect = Effect.NONE;
        for (Parameter parameter : ParameterTable.of(holder.getClass()).getParameters()) {
            List<Object> values = parameter.values(holder);
            Effect one = Effect.NONE;
            if (parameter.getKind() == Parameter.Kind.GROUP) {
                one = replaceInGroups(holder, parameter, values);
            } else if (parameter.isNameOf(part) && values.contains(old)) {
                one = now == null ? take(holder, parameter, values, List.of(old)) : rename(holder, parameter, values);
            }
            effect = one.compareTo(effect) > 0 ? one : effect;
        }
        return effect;
    }

    private Effect rename(Object holder, Parameter parameter, List<Object> values) {
        Collections.replaceAll(values, old, now);
        parameter.set(holder, parameter.isList() ? values : values.get(0));
        return Effect.CHANGED;
    }

    private Effect replaceInGroups(Object holder, Parameter parameter, List<Object> groups) {
        Effect effect = Effect.NONE;
        List<Object> useless = new ArrayList<>();
        for (Object group : groups) {
            Effect one = replace(group);
            if (one == Effect.USELESS) {
                useless.add(group);
            } else if (one == Effect.CHANGED) {
                effect = one;
            }
        }
        return useless.isEmpty() ? effect : take(holder, parameter, groups, useless);
    }

    /** Removes values from a parameter. */
    private Effect take(Object holder, Parameter parameter, List<Object> values, List<?> taken) {
        values.removeAll(taken);
        Object none = ParameterTable.of(holder.getClass()).newInstance();
        parameter.set(holder, parameter.isList() ? values : parameter.get(none));
        for (Object each : taken) {
            if (each instanceof SearObject) {
                delete((SearObject) each);
            } else if (holder instanceof SearObject) {
                boolean group = parameter.getKind() == Parameter.Kind.GROUP;
                lost.add(called((SearObject) holder) + LOST + parameter.getName() + (group ? " to " : " ") + old);
            }
        }
        return values.isEmpty() && parameter.isNeeded() ? Effect.USELESS : Effect.CHANGED;
    }

    /** Returns class and name: {@code motor left}, {@code LIDAR front}. */
    static String called(SearObject object) {
        String type = object.getClass().getSimpleName();
        boolean capitals = type.equals(type.toUpperCase(Locale.ROOT));
        return (capitals ? type : type.toLowerCase(Locale.ROOT)) + " " + object.getName();
    }
}
