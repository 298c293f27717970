package rasterlab.app.visibility;

import java.text.NumberFormat;
import java.util.List;
import java.util.Optional;
import java.util.StringJoiner;
import java.util.function.Function;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.plan.least.PlanReadings;
import rasterlab.app.visibility.scene.VisibilityChoice;
import rasterlab.engine.visibility.VisibilityWork;

/** The live numbers of a state as the inspector writes them. */
final class VisibilityReadings {
    private final VisibilityLabModel model;
    private final VisibilityLabState state;
    private final Texts texts;

    VisibilityReadings(VisibilityLabModel model, Texts texts) {
        this.model = model;
        state = model.state();
        this.texts = texts;
    }

    /** θ, φ, ρ, zoom, time of a frame, size. */
    List<String> view() {
        VisibilityChoice choice = state.choice();
        return List.of(
                angle(choice.camera().thetaRadians()),
                angle(choice.camera().phiRadians()),
                Shown.number(choice.camera().rho(), 1, texts.locale()),
                "× " + number(model.shownZoom(), 2),
                frameTime(),
                size());
    }

    /** θ as a multiple of π. */
    String thetaOfPi() {
        return number(state.choice().camera().thetaRadians() / Math.PI, 2);
    }

    private String size() {
        return state.picture()
                .map(picture -> picture.raster().width() + " × " + picture.raster().height())
                .orElse("–");
    }

    private String frameTime() {
        if (state.medianNanos() == 0) return texts.text("frameTime.none");
        return texts.text("frameTime.millis", number(state.medianNanos() / 1e6, 1));
    }

    /** The number of wrong pixels, with the method's name where there is another. */
    String wrongPixels() {
        VisibilityChoice choice = state.choice();
        return choice.comparison().isEmpty()
                ? read(
                        first(),
                        found -> texts.text("wrongPixels.count", found.wrongPixels()),
                        refused(choice.visibility()))
                : wrongPixels(choice.visibility(), first());
    }

    String missing() {
        return compared(difference -> count(difference.missing()));
    }

    String extra() {
        return compared(difference -> count(difference.extra()));
    }

    String miscolored() {
        return compared(difference -> count(difference.miscolored()));
    }

    String share() {
        return compared(
                difference -> texts.text("share.percent", number(100 * difference.share(), 3)));
    }

    String largest() {
        return compared(
                difference ->
                        texts.text(
                                "largest.levels",
                                difference.difference().largestLevelDifference()));
    }

    /** Wrong pixels of the other method, with its name. */
    String other() {
        return wrongPixels(state.choice().comparison(), state.otherOutcome());
    }

    private Optional<Differences.PictureOutcome> first() {
        return state.differences().map(Differences::first);
    }

    private String wrongPixels(String method, Optional<Differences.PictureOutcome> outcome) {
        String counted = read(outcome, found -> count(found.wrongPixels()), refused(method));
        return texts.text("wrongPixels.of", OwnWords.called(method, texts.language()), counted);
    }

    /** The sign in place of a count where the method drew nothing. */
    private String refused(String method) {
        return OwnWords.without(method, texts.text("wrongPixels.refused"), texts.language());
    }

    /** Why the method's pixels are not counted; empty where they are. */
    Optional<String> refusal() {
        return refusal(state.choice().visibility(), first());
    }

    /** The reason of the other method; empty where its pixels are counted. */
    Optional<String> otherRefusal() {
        return refusal(state.choice().comparison(), state.otherOutcome());
    }

    private Optional<String> refusal(String method, Optional<Differences.PictureOutcome> outcome) {
        return outcome.filter(found -> state.step() == Frame.ALL)
                .flatMap(Differences.PictureOutcome::refusal)
                .map(said -> refusal(method, said, texts));
    }

    /** Steps done, cuts so far, and what was counted for the whole picture. */
    List<String> work() {
        if (!state.choice().drawing())
            return List.of(texts.text("stepNow.off"), "–", "–", "–", "–");
        if (state.drawn().isEmpty()) return List.of(noSteps(), "–", "–", "–", "–");
        Drawn drawn = state.drawn().get();
        int done = Math.min(state.step(), drawn.steps().size());
        VisibilityWork work = drawn.work();
        return List.of(
                texts.text("stepNow.of", count(done), count(drawn.steps().size())),
                cuts(drawn, done),
                count(work.comparisons()),
                count(work.depthTests()),
                count(work.pixelsWritten()));
    }

    private String noSteps() {
        if (model.lacksSteps()) return texts.text("stepNow.none");
        return texts.text(state.lent() ? "stepNow.lent" : "stepNow.unknown");
    }

    /**
     * The number of cuts so far and in all; in all only where they were made before the first step.
     */
    private String cuts(Drawn drawn, int done) {
        String all = count(drawn.work().splits());
        return drawn.cutsOnTheWay() ? texts.text("cuts.of", count(drawn.cuts(done)), all) : all;
    }

    /** The words behind the timeline. */
    String timeline() {
        if (!state.choice().drawing()) return texts.text("turntable", thetaOfPi());
        if (model.lacksSteps()) return texts.text("timeline.none");
        int last = state.drawn().map(drawn -> drawn.steps().size()).orElse(0);
        return count(Math.min(state.step(), last)) + " / " + count(last);
    }

    /** The meaning of the steps' values; "" where there are no steps. */
    String decision() {
        return state.drawn().map(Drawn::decision).map(this::decision).orElse("");
    }

    /**
     * @param english in the engine's words
     */
    private String decision(String english) {
        String method = state.choice().visibility();
        if (method.equals(OwnMethods.NAME)) return texts.text("decision." + model.ownTopic());
        return Texts.ofTopic("hidden-surfaces", texts.language())
                .textOr(method + ".decision", english);
    }

    /** Why a method drew nothing: in its own words where those are the window's language. */
    static String refusal(String method, String message, Texts texts) {
        return OwnWords.refusal(method, message, texts.language())
                .orElseGet(() -> refused(method, message, texts));
    }

    private static String refused(String method, String message, Texts texts) {
        String own =
                texts.text("refused.by", method, Complaints.translated(texts.language(), message));
        return texts.language() == Language.ENGLISH ? own : texts.textOr("refused." + method, own);
    }

    /** The sentences over the pictures; "" for none. */
    String overStage() {
        var said = new StringJoiner(" ");
        if (!state.problem().isEmpty())
            said.add(
                    texts.text(
                            "problem", Complaints.translated(texts.language(), state.problem())));
        else state.note().ifPresent(note -> said.add(note.in(texts.language())));
        if (state.showsNothing()) said.add(texts.text("empty"));
        var plan = new PlanReadings(texts.language());
        model.bills().magnified(state).ifPresent(shown -> said.add(plan.difference(shown)));
        return said.toString();
    }

    String pixel() {
        if (state.chosen().isEmpty()) return texts.text("pixel.none");
        ChosenPixel at = state.chosen().get();
        String place = Shown.point(at.x(), at.y(), texts.locale());
        boolean untold = state.pixel().isPresent() && !state.pixel().get().askable();
        return untold ? texts.text("pixel.untold", place) : place;
    }

    String stored() {
        return state.pixel()
                .filter(report -> report.stored().isPresent())
                .map(report -> Shown.number(report.stored().getAsDouble(), 7, texts.locale()))
                .orElse("–");
    }

    private String count(long number) {
        return NumberFormat.getIntegerInstance(texts.locale()).format(number);
    }

    private String compared(Function<Compared, String> reading) {
        return read(first(), reading, "–");
    }

    /**
     * Reads all pixels of the picture that is drawn to its end.
     *
     * @param refused stands where the method refuses the scene
     */
    private String read(
            Optional<Differences.PictureOutcome> outcome,
            Function<Compared, String> reading,
            String refused) {
        if (state.choice().tolerance().isPresent()) return "–";
        if (state.step() != Frame.ALL) return texts.text("known.later");
        String meanwhile = state.choice().difference() ? texts.text("comparing") : "–";
        return outcome.map(found -> found.compared().map(reading).orElse(refused))
                .orElse(meanwhile);
    }

    /** Radians, and the same as a multiple of π. */
    private String angle(double radians) {
        return texts.text("angle", number(radians, 3), number(radians / Math.PI, 3));
    }

    private String number(double value, int decimals) {
        NumberFormat format = NumberFormat.getInstance(texts.locale());
        format.setMinimumFractionDigits(decimals);
        format.setMaximumFractionDigits(decimals);
        return format.format(value).replace('-', '−');
    }
}
