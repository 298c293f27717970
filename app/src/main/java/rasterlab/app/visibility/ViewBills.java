package rasterlab.app.visibility;

import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.plan.bill.Bills;
import rasterlab.app.plan.bill.PictureBill;
import rasterlab.app.plan.bill.PictureBill.BilledPicture;
import rasterlab.app.plan.least.MagnifiedDifference;
import rasterlab.app.plan.least.PlanBill;
import rasterlab.app.plan.least.PlannedPicture;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.plan.Plan;

/** All that is counted and measured of the pictures when nothing moves. */
final class ViewBills implements AutoCloseable {
    private final Bills<BilledPicture, PictureBill> counted;
    private final Bills<PlannedPicture, PlanBill> planned;

    /**
     * @param events runs what it is given on the one thread that uses this, in order
     * @param onFailure told what counting threw, on any thread
     * @param refuted told each plan that measuring found outside its tolerance
     */
    ViewBills(Executor events, Consumer<Throwable> onFailure, Consumer<Plan> refuted) {
        counted = PictureBill.bills(events, onFailure);
        planned = PlanBill.bills(events, onFailure);
        planned.listen(
                bills ->
                        bills.bill()
                                .filter(bill -> bills.current() && !bill.holds())
                                .ifPresent(bill -> refuted.accept(bill.trial().plan())));
    }

    /** The counted work of the picture that is shown. */
    Bills<BilledPicture, PictureBill> counted() {
        return counted;
    }

    /** The least picture beside the full one. */
    Bills<PlannedPicture, PlanBill> planned() {
        return planned;
    }

    /**
     * Asks for the bills of a picture.
     *
     * @param request by the chosen method; what a plan draws instead, once it is there, counts more
     */
    void ask(RenderRequest request, VisibilityLabState state) {
        if (state.least().isEmpty()) counted.ask(new BilledPicture(request, Optional.empty()));
        measure(state);
    }

    /** Asks for the bills of the least picture, where the present choice has one. */
    void measure(VisibilityLabState state) {
        state.least()
                .ifPresent(
                        picture -> {
                            Plan plan = picture.plan();
                            counted.ask(
                                    new BilledPicture(
                                            plan.from(picture.camera()), Optional.of(plan)));
                            planned.ask(picture);
                        });
    }

    /** Drops what is being counted: another picture is shown. */
    void cancel() {
        counted.cancel();
        planned.cancel();
    }

    /** The difference that is shown in place of the picture; empty while it is not known. */
    Optional<MagnifiedDifference> magnified(VisibilityLabState state) {
        boolean wanted = state.choice().least().magnified() && state.least().isPresent();
        return planned.bill().filter(bill -> wanted && planned.current()).map(PlanBill::difference);
    }

    /** Waits until what was asked so far is found or dropped. Any other thread. */
    void settle() throws InterruptedException {
        counted.settle();
        planned.settle();
    }

    @Override
    public void close() {
        counted.close();
        planned.close();
    }
}
