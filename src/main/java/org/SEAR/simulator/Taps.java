package org.SEAR.simulator;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.SEAR.devices.SerialLine;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.orders.BodyOrder;

/** Several who look at one run, told one after the other. Who comes or leaves makes another of these. Simulation thread. */
final class Taps implements RunTap {
    private final List<RunTap> all;

    private Taps(List<RunTap> all) {
        this.all = all;
    }

    /**
     * Who looks when one has come or left.
     *
     * @param before null for nobody
     * @param on whether it comes
     * @return null for nobody
     */
    static RunTap changed(RunTap before, RunTap who, boolean on) {
        List<RunTap> now = new ArrayList<>(before instanceof Taps ? ((Taps) before).all : before == null ? List.of() : List.of(before));
        now.remove(who);
        if (on) {
            now.add(who);
        }
        return now.isEmpty() ? null : now.size() == 1 ? now.get(0) : new Taps(now);
    }

    private void tell(Consumer<RunTap> event) {
        all.forEach(event);
    }

    @Override
    public void drive(DriveCommand command) {
        tell(one -> one.drive(command));
    }

    @Override
    public void order(ActuatorOrder order) {
        tell(one -> one.order(order));
    }

    @Override
    public void order(BodyOrder order) {
        tell(one -> one.order(order));
    }

    @Override
    public void power(String device, boolean on) {
        tell(one -> one.power(device, on));
    }

    @Override
    public void moved(String name, Pose start, Pose to) {
        tell(one -> one.moved(name, start, to));
    }

    @Override
    public void reset() {
        tell(RunTap::reset);
    }

    @Override
    public void attended(int part) {
        tell(one -> one.attended(part));
    }

    @Override
    public void stepped(Simulation simulation) {
        tell(one -> one.stepped(simulation));
    }

    @Override
    public void standing() {
        tell(RunTap::standing);
    }

    @Override
    public void heard(SerialLine line, byte[] bytes, int count) {
        tell(one -> one.heard(line, bytes, count));
    }

    @Override
    public void said(SerialLine line, byte[] bytes) {
        tell(one -> one.said(line, bytes));
    }

    @Override
    public void baud(SerialLine line, int baud) {
        tell(one -> one.baud(line, baud));
    }

    @Override
    public void opened(SerialLine line) {
        tell(one -> one.opened(line));
    }

    @Override
    public void hungUp(SerialLine line) {
        tell(one -> one.hungUp(line));
    }
}
