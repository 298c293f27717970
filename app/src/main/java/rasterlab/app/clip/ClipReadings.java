package rasterlab.app.clip;

import java.util.Arrays;
import java.util.Locale;
import rasterlab.app.canvas.Shown;
import rasterlab.app.clip.outcome.ClipStep;
import rasterlab.app.clip.outcome.Clipping;
import rasterlab.app.clip.outcome.Codes;
import rasterlab.app.clip.outcome.SegmentClipping;
import rasterlab.app.clip.scene.ClipGrip;
import rasterlab.app.clip.scene.ClipScene;
import rasterlab.app.clip.scene.PolygonClipScene;
import rasterlab.app.clip.scene.SegmentScene;
import rasterlab.app.clip.scene.ShownWindow;
import rasterlab.app.clip.scene.SpacePoint;
import rasterlab.app.clip.scene.SpaceSegment;
import rasterlab.app.clip.scene.VolumeScene;
import rasterlab.app.language.Texts;
import rasterlab.engine.clip.volume.CohenSutherland6;

/** The live numbers of a state as the inspector writes them. */
final class ClipReadings {
    private static final String NONE = "–";
    private static final int DECIMALS = 3;

    private final ClipLabState state;
    private final ClipScene scene;
    private final Texts texts;

    ClipReadings(ClipLabState state, Texts texts) {
        this.state = state;
        this.texts = texts;
        scene = state.results().scene();
    }

    /** Which segment or side the step is about. */
    String tested() {
        return state.current()
                .map(step -> scene instanceof PolygonClipScene ? at(step) : item(step) + at(step))
                .orElseGet(this::beforeOrAfter);
    }

    private String beforeOrAfter() {
        int steps = state.results().clipping().steps().size();
        if (state.results().clipping().ending() == Clipping.ClipEnding.ENDLESS && state.finished())
            return texts.text("step.endless");
        return state.finished() ? texts.text("step.result", steps) : texts.text("step.none");
    }

    private String item(ClipStep step) {
        return "A" + (step.item() + 1) + "B" + (step.item() + 1) + ": ";
    }

    private String at(ClipStep step) {
        if (step.passing() == ClipStep.Passing.BOTH)
            return texts.text("at.chain", point(Arrays.copyOf(step.places(), 2)));
        if (scene instanceof VolumeScene) return worded(step.at()).replace('-', '−');
        ShownWindow window =
                scene instanceof SegmentScene segments
                        ? segments.window()
                        : ((PolygonClipScene) scene).window();
        if (!window.upright() && step.border() >= 0)
            return texts.text("at.edge", step.border() + 1);
        if (scene instanceof PolygonClipScene && step.border() >= 0)
            return worded(new String[] {"bottom", "right", "top", "left"}[step.border() % 4]);
        return worded(step.at());
    }

    private String worded(String at) {
        if (at.isEmpty()) return texts.text("at.nothing");
        return texts.textOr("at." + at.replace(' ', '-'), at);
    }

    String decision() {
        return state.current().map(this::decision).orElse(NONE);
    }

    private String decision(ClipStep step) {
        if (scene instanceof PolygonClipScene) return texts.text("corners", (int) step.decision());
        String decided = Codes.decision(state.results().clipping().decidesByCode(), step, locale());
        if (decided.isEmpty()) return NONE;
        String passing = "passing." + step.passing().name().toLowerCase(Locale.ROOT);
        return texts.has(passing) ? decided + ", " + texts.text(passing) : decided;
    }

    /** The first end of what is left so far of the segment in question. */
    String from() {
        return end(0);
    }

    /** The second end of the segment. */
    String to() {
        return end(1);
    }

    private String end(int end) {
        if (scene instanceof PolygonClipScene) return NONE;
        double[] left = left();
        if (left.length == 0) return texts.text("left.nothing");
        int dimension = left.length / 2;
        return point(Arrays.copyOfRange(left, end * dimension, (end + 1) * dimension));
    }

    private double[] left() {
        if (state.current().isPresent()) return state.current().get().left();
        if (state.finished())
            return state.results()
                    .clipping()
                    .part(item())
                    .map(Clipping.ClipPart::coordinates)
                    .orElse(new double[0]);
        return scene instanceof SegmentScene plane
                ? plane.segments().get(item()).ends()
                : ((VolumeScene) scene).segments().get(item()).ends();
    }

    /** Region codes of the ends of the segment in question. */
    String codes() {
        int[] codes = ends();
        if (codes.length == 0) return NONE;
        int width = scene instanceof VolumeScene ? 6 : 4;
        int number = item() + 1;
        return "A%d %s   B%d %s"
                .formatted(
                        number, Codes.bits(codes[0], width), number, Codes.bits(codes[1], width));
    }

    /** The verdict of the two codes together. */
    String verdict() {
        int[] codes = ends();
        if (codes.length == 0) return NONE;
        int width = scene instanceof VolumeScene ? 6 : 4;
        if ((codes[0] & codes[1]) != 0)
            return texts.text("verdict.outside", Codes.bits(codes[0] & codes[1], width));
        return codes[0] == 0 && codes[1] == 0
                ? texts.text("verdict.inside")
                : texts.text("verdict.cut");
    }

    private int[] ends() {
        if (scene instanceof SegmentScene segments && segments.window().upright())
            return SegmentClipping.codes(segments, item());
        if (!(scene instanceof VolumeScene volume)) return new int[0];
        SpaceSegment segment = volume.segments().get(item());
        return new int[] {code(volume, segment.a()), code(volume, segment.b())};
    }

    static int code(VolumeScene volume, SpacePoint p) {
        return CohenSutherland6.code(volume.zmin(), p.x(), p.y(), p.z());
    }

    /** The segment that the step is about, else the one with the selected end. */
    private int item() {
        int segments =
                scene instanceof SegmentScene plane
                        ? plane.segments().size()
                        : ((VolumeScene) scene).segments().size();
        ClipGrip selected = state.selected();
        int chosen = selected.kind() == ClipGrip.ClipGripKind.END ? selected.index() : 0;
        return Math.min(segments - 1, state.current().map(ClipStep::item).orElse(chosen));
    }

    String selected() {
        return texts.text(
                "grip." + state.selected().kind().name().toLowerCase(Locale.ROOT),
                state.selected().label());
    }

    String missing() {
        return count(state.results().clipping().deviation().missing());
    }

    String extra() {
        return count(state.results().clipping().deviation().extra());
    }

    /** Nothing is told of how right an answer is that never came. */
    private static boolean unanswered(Clipping clipping) {
        return clipping.ending() != Clipping.ClipEnding.ENDED;
    }

    private String count(long parts) {
        if (unanswered(state.results().clipping())) return NONE;
        if (!state.finished()) return texts.text("known.later");
        return texts.text("parts." + scene.mode().code(), parts);
    }

    String worst() {
        return worst(state.results().clipping());
    }

    private String worst(Clipping clipping) {
        if (unanswered(clipping)) return NONE;
        if (!state.finished()) return texts.text("known.later");
        double worst = clipping.deviation().worst();
        return texts.text("worst." + scene.mode().code(), small(worst));
    }

    /** The value as a power of ten where it is small, with superscript digits. */
    private String small(double value) {
        if (!(value > 0 && value < 1e-4)) return Shown.number(value, locale());
        int exponent = (int) Math.floor(Math.log10(value));
        var power = new StringBuilder();
        for (char digit : String.valueOf(-exponent).toCharArray())
            power.append("⁰¹²³⁴⁵⁶⁷⁸⁹".charAt(digit - '0'));
        return Shown.number(value / Math.pow(10, exponent), 1, locale()) + "·10⁻" + power;
    }

    /** The second method beside the exact answer in one line; "" when none is compared. */
    String other() {
        return state.results().other().map(this::other).orElse("");
    }

    private String other(Clipping second) {
        if (unanswered(second)) return NONE;
        if (!state.finished()) return texts.text("known.later");
        return texts.text("other.wrong", second.deviation().missing(), second.deviation().extra());
    }

    private String point(double[] coordinates) {
        if (coordinates.length < 3)
            return Shown.point(rounded(coordinates[0]), rounded(coordinates[1]), locale());
        String plane = Shown.point(rounded(coordinates[0]), rounded(coordinates[1]), locale());
        String separator = plane.contains(";") ? "; " : ", ";
        return plane.substring(0, plane.length() - 1)
                + separator
                + Shown.number(coordinates[2], DECIMALS, locale())
                + ")";
    }

    private static double rounded(double value) {
        double scale = Math.pow(10, DECIMALS);
        return Math.abs(value) < 1e9 ? Math.rint(value * scale) / scale : value;
    }

    private Locale locale() {
        return texts.locale();
    }
}
