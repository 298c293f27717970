package rasterlab.app.light;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.plan.least.PlanWish;
import rasterlab.contract.Reflection;
import rasterlab.engine.light.LightModel;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.light.Substance;
import rasterlab.engine.range.Bounds;
import rasterlab.engine.transform.SphericalView;

/**
 * The user's choice, which undo brings back.
 *
 * @param body what is lit
 * @param camera where it is seen from
 * @param zoom picture scale as a multiple of the scene's own, {@value #SMALLEST} to {@value
 *     #LARGEST}
 * @param material of the body
 * @param lamps at least one
 * @param selected the lamp whose settings are shown
 * @param ambient light from everywhere
 * @param terms of the formula that are seen
 * @param reflection the specular term
 * @param localViewer whether each point has its own direction to the eye
 * @param twoSided whether backs are lit by themselves
 * @param arrows whether normals are drawn
 * @param mach whether the profile shows what the eye reports
 * @param line the profile's ends and the point
 * @param shaded the topic by whose program, the user's own, it is lit; "" for the three shadings
 * @param least the least light that is enough, in place of the three shadings
 */
public record LightChoice(
        LitBody body,
        SphericalView camera,
        double zoom,
        MaterialChoice material,
        List<Lamp> lamps,
        int selected,
        double ambient,
        Set<LightTerm> terms,
        Reflection reflection,
        boolean localViewer,
        boolean twoSided,
        boolean arrows,
        boolean mach,
        LightMarks line,
        String shaded,
        PlanWish least) {
    static final int MOST_LAMPS = 6;
    static final double SMALLEST = 0.25;
    static final double LARGEST = 8;

    /**
     * Places in front of the scene, as {@link MarkPlaces} has them: from 0 to 1 in the frame that
     * every picture shows, below 0 and above 1 beside it, x to the right and y down.
     *
     * @param fromX of the profile's first end
     * @param toX of its other end
     * @param atX of the point
     */
    public record LightMarks(
            double fromX, double fromY, double toX, double toY, double atX, double atY) {}

    public LightChoice {
        Bounds.require("zoom", zoom, SMALLEST, LARGEST);
        lamps = List.copyOf(lamps);
        terms = Set.copyOf(terms);
        // A choice that an earlier version kept has no value here.
        if (shaded == null) shaded = "";
        if (least == null) least = PlanWish.FIRST.withMagnified(true);
    }

    /** A coarse brass sphere under a lamp and a dim second one. */
    public static LightChoice first() {
        return new LightChoice(
                new LitBody("sphere", 12, LitBody.OWN),
                new SphericalView(Math.PI / 9, 1.2, 500),
                1.5,
                MaterialChoice.of(Substance.BRASS),
                List.of(
                        Lamp.at(112, -18, 103),
                        Lamp.at(35, 109, -16).withStrength(0.4).colored(0x9EC9FF)),
                0,
                LightModel.AMBIENT,
                LightTerm.all(),
                Reflection.BLINN_PHONG,
                true,
                true,
                false,
                true,
                new LightMarks(0.1, 0.5, 0.9, 0.5, 0.4, 0.37),
                "",
                PlanWish.FIRST.withMagnified(true));
    }

    public LightChoice with(LitBody other) {
        var draft = new Draft(this);
        draft.body = other;
        return draft.choice();
    }

    LightChoice with(SphericalView other) {
        var draft = new Draft(this);
        draft.camera = other;
        return draft.choice();
    }

    public LightChoice zoomed(double factor) {
        return withZoom(Math.max(SMALLEST, Math.min(LARGEST, zoom * factor)));
    }

    LightChoice withZoom(double factor) {
        var draft = new Draft(this);
        draft.zoom = factor;
        return draft.choice();
    }

    /** Other lamps, the first of them selected. */
    LightChoice withLamps(List<Lamp> other) {
        return with(other, 0);
    }

    public LightChoice with(MaterialChoice other) {
        var draft = new Draft(this);
        draft.material = other;
        return draft.choice();
    }

    public LightChoice selecting(int lamp) {
        var draft = new Draft(this);
        draft.selected = lamp;
        return draft.choice();
    }

    private LightChoice with(List<Lamp> other, int shown) {
        var draft = new Draft(this);
        draft.lamps = other;
        draft.selected = shown;
        return draft.choice();
    }

    public LightChoice withAmbient(double share) {
        var draft = new Draft(this);
        draft.ambient = share;
        return draft.choice();
    }

    public LightChoice withTerms(Set<LightTerm> other) {
        var draft = new Draft(this);
        draft.terms = other;
        return draft.choice();
    }

    public LightChoice with(Reflection other) {
        var draft = new Draft(this);
        draft.reflection = other;
        return draft.choice();
    }

    public LightChoice withLocalViewer(boolean local) {
        var draft = new Draft(this);
        draft.localViewer = local;
        return draft.choice();
    }

    public LightChoice withTwoSides(boolean two) {
        var draft = new Draft(this);
        draft.twoSided = two;
        return draft.choice();
    }

    public LightChoice withArrows(boolean drawn) {
        var draft = new Draft(this);
        draft.arrows = drawn;
        return draft.choice();
    }

    public LightChoice withMach(boolean drawn) {
        var draft = new Draft(this);
        draft.mach = drawn;
        return draft.choice();
    }

    public LightChoice with(LightMarks other) {
        var draft = new Draft(this);
        draft.line = other;
        return draft.choice();
    }

    /** The choice lit by the user's own program on that topic; "" for the three shadings. */
    public LightChoice withShaded(String topic) {
        var draft = new Draft(this);
        draft.shaded = topic;
        draft.least = least.with(false);
        return draft.choice();
    }

    /** The choice lit by the least light that is enough, or by the three shadings. */
    public LightChoice with(PlanWish wish) {
        var draft = new Draft(this);
        draft.least = wish;
        if (wish.on()) draft.shaded = "";
        return draft.choice();
    }

    /**
     * The choice lit by the user's own program on a topic about light: by its normals, drawn as
     * arrows, or by the light that it finds, whose mirrored term is Phong's.
     */
    public LightChoice byOwn(String topic) {
        if (topic.equals(OwnNormals.TOPIC))
            return with(body.withNormals(OwnMethods.NAME)).withShaded("").withArrows(true);
        return withShaded(topic).with(Reflection.PHONG);
    }

    /** The lamp whose settings are shown. */
    public Lamp lamp() {
        return lamps.get(selected);
    }

    /** That lamp in place of the selected one. */
    public LightChoice withLamp(Lamp other) {
        return withLamp(selected, other);
    }

    public LightChoice withLamp(int index, Lamp other) {
        var next = new ArrayList<>(lamps);
        next.set(index, other);
        return with(next, index);
    }

    /** Adds a lamp and selects it, unless there are {@value #MOST_LAMPS}. */
    public LightChoice grown() {
        if (lamps.size() == MOST_LAMPS) return this;
        var next = new ArrayList<>(lamps);
        Lamp last = lamp();
        next.add(Lamp.at(-last.x(), -last.y(), last.z()).withStrength(0.5));
        return with(next, next.size() - 1);
    }

    /** The choice without the selected lamp, unless it is the only one. */
    public LightChoice shrunk() {
        if (lamps.size() == 1) return this;
        var next = new ArrayList<>(lamps);
        next.remove(selected);
        return with(next, Math.min(selected, next.size() - 1));
    }

    /** The light of the scene with all lamps that shine. */
    public LightModel model() {
        double[] everywhere = {ambient, ambient, ambient};
        return new LightModel(
                everywhere,
                localViewer,
                twoSided,
                reflection,
                lamps.stream().filter(Lamp::on).map(Lamp::light).toList());
    }

    /** Parts of a choice, to be changed one by one. */
    private static final class Draft {
        private LitBody body;
        private SphericalView camera;
        private double zoom;
        private MaterialChoice material;
        private List<Lamp> lamps;
        private int selected;
        private double ambient;
        private Set<LightTerm> terms;
        private Reflection reflection;
        private boolean localViewer;
        private boolean twoSided;
        private boolean arrows;
        private boolean mach;
        private LightMarks line;
        private String shaded;
        private PlanWish least;

        Draft(LightChoice from) {
            body = from.body;
            camera = from.camera;
            zoom = from.zoom;
            material = from.material;
            lamps = from.lamps;
            selected = from.selected;
            ambient = from.ambient;
            terms = from.terms;
            reflection = from.reflection;
            localViewer = from.localViewer;
            twoSided = from.twoSided;
            arrows = from.arrows;
            mach = from.mach;
            line = from.line;
            shaded = from.shaded;
            least = from.least;
        }

        LightChoice choice() {
            return new LightChoice(
                    body,
                    camera,
                    zoom,
                    material,
                    lamps,
                    selected,
                    ambient,
                    terms,
                    reflection,
                    localViewer,
                    twoSided,
                    arrows,
                    mach,
                    line,
                    shaded,
                    least);
        }
    }
}
