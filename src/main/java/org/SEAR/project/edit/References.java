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
 * The names by which parts of a robot know each other: a motor its wheels, a servo what it turns, a wheel its servo, a bumper what presses it, an
 * Arduino what is wired to it. The grammar says which parameters these are, and what can't be without them. One use for one part that gets another
 * name or leaves its robot; whoever holds the project's lock.
 */
final class References {
    /** What has become of an object or group that may have had the name; the later one counts. */
    private enum Effect { NONE, CHANGED, USELESS }

    private static final String LOST = " lost its ";

    private final EditDraft draft;
    private final SEARrobot robot;
    /** Parts that have left, whose names are still to be forgotten. */
    private final Deque<SearObject> left = new ArrayDeque<>();
    private final List<SearObject> deleted = new ArrayList<>();
    private final Set<String> lost = new LinkedHashSet<>();
    private SearObject part;
    private String old;
    /** What stands in the old name's place; null for nothing. */
    private String now;

    /** @param robot as it is to be, with the part's new name or without it */
    References(EditDraft draft, SEARrobot robot) {
        this.draft = draft;
        this.robot = robot;
    }

    /**
     * Has the names in the robot's file and in those of its parts follow a part that has another name now.
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

    /** Takes a part's name away from the robot's file and those of its parts. What can't be without it is deleted, and forgotten likewise. */
    void forget(SearObject gone) throws IOException {
        left.add(gone);
        while (!left.isEmpty()) {
            part = left.remove();
            old = part.getName();
            now = null;
            replaceEverywhere();
        }
    }

    /** What was deleted because it can't be without what was forgotten. */
    List<SearObject> deleted() {
        return deleted;
    }

    /** What other objects had of it and have no more, as "servo pan lost its part eye". */
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

    /** Takes values away from a parameter. */
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

    /** {@code motor left}, {@code LIDAR front}. */
    static String called(SearObject object) {
        String type = object.getClass().getSimpleName();
        boolean capitals = type.equals(type.toUpperCase(Locale.ROOT));
        return (capitals ? type : type.toLowerCase(Locale.ROOT)) + " " + object.getName();
    }
}
