package rasterlab.app.visibility.scene;

import java.util.Optional;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.plan.least.PlanWish;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.plan.Tolerance;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.texture.TextureEnvironment.Mode;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;

/**
 * The user's choice, which undo brings back.
 *
 * @param shown the scene
 * @param visibility a visibility method's name
 * @param comparison another one's beside it, "" for none
 * @param shading a shading's name
 * @param projection a projection's name
 * @param zoom picture scale as a multiple of the scene's own, {@value #SMALLEST} to {@value
 *     #LARGEST}
 * @param edges whether faces get edges, where the method draws any
 * @param difference whether wrong pixels are marked
 * @param view what the stage shows
 * @param drawing whether the timeline goes through the method's steps; otherwise the scene turns
 * @param look all the rest
 * @param least the least picture in place of the method's
 */
public record VisibilityChoice(
        SceneChoice shown,
        String visibility,
        String comparison,
        String shading,
        String projection,
        SphericalView camera,
        double zoom,
        boolean edges,
        boolean difference,
        StageView view,
        boolean drawing,
        LookChoice look,
        PlanWish least) {
    static final double SMALLEST = 0.25;
    static final double LARGEST = 32;

    /** The shading that tells the faces of scenes with several colours apart. */
    static final String OWN_COLORS = "flat";

    private static final String VASE_TONES = "tone";

    private static final double FIRST_ZOOM = 1.6;

    public VisibilityChoice {
        // A choice that an earlier version kept has no value here.
        if (least == null) least = PlanWish.FIRST;
        if (!(zoom >= SMALLEST && zoom <= LARGEST))
            throw new IllegalArgumentException(
                    "zoom must be in [" + SMALLEST + ", " + LARGEST + "], got " + zoom);
    }

    /** The vase by the painter, as its author shades it. */
    public static VisibilityChoice first() {
        SceneChoice vase = SceneChoice.named("vase");
        return new VisibilityChoice(
                vase,
                "painter",
                "",
                VASE_TONES,
                "perspective",
                vase.scene().defaultCamera(),
                FIRST_ZOOM,
                false,
                false,
                StageView.COLORS,
                false,
                LookChoice.USUAL,
                PlanWish.FIRST);
    }

    /** The scene's name, or its file's. */
    public String scene() {
        return shown.name();
    }

    /** Zooms by a factor; stops at the ends of the range. */
    public VisibilityChoice zoomed(double factor) {
        return withZoom(Math.max(SMALLEST, Math.min(LARGEST, zoom * factor)));
    }

    VisibilityChoice withZoom(double other) {
        var draft = new Draft(this);
        draft.zoom = other;
        return draft.choice();
    }

    /** The scene as it is first shown, everything else kept that suits it. */
    public VisibilityChoice withScene(String other) {
        return with(SceneChoice.named(other));
    }

    /** The choice of another scene, as it is first shown. */
    VisibilityChoice with(SceneChoice other) {
        return with(other, other.scene().defaultCamera());
    }

    VisibilityChoice with(SceneChoice other, SphericalView eye) {
        var draft = new Draft(this);
        draft.shown = other;
        draft.camera = eye;
        draft.zoom = other.name().equals(shown.name()) ? zoom : usualZoom(other);
        draft.look = suited(look, other);
        return draft.choice();
    }

    /** This choice, whose scene shows that input of a topic. */
    public VisibilityChoice showing(Object input) {
        var draft = new Draft(this);
        draft.shown = shown.showing(input);
        return draft.choice();
    }

    /** This choice with a scene of the lab in the place of one that no name brings back. */
    public VisibilityChoice withoutFiles() {
        return shown.known() ? this : alike(shown.withoutFiles().orElse(first().shown));
    }

    /**
     * The choice of another scene, seen from the same side, as far away for its size and as large.
     */
    VisibilityChoice alike(SceneChoice other) {
        double first = shown.scene().defaultCamera().rho();
        double larger = other.scene().defaultCamera().rho() / first;
        var eye =
                new SphericalView(
                        camera.thetaRadians(), camera.phiRadians(), camera.rho() * larger);
        return with(other, eye).withZoom(zoom).zoomed(usualZoom(other) / usualZoom(shown));
    }

    /** Zoom by which the scene is first shown. */
    public double usualZoom() {
        return usualZoom(shown);
    }

    /** The vase's own scale leaves room for every view; others fill the picture. */
    private static double usualZoom(SceneChoice scene) {
        return scene.name().equals("vase") ? FIRST_ZOOM : 1;
    }

    /** Decals need a texture with colours. */
    private static LookChoice suited(LookChoice look, SceneChoice scene) {
        boolean decal = look.change().environment().equals(Optional.of(Mode.DECAL));
        return decal && scene.fewestComponents() < 3
                ? look.withEnvironment(Optional.empty())
                : look;
    }

    public VisibilityChoice withVisibility(String other) {
        var draft = new Draft(this);
        draft.visibility = other;
        draft.least = least.with(false);
        return draft.choice();
    }

    /** A scene by two methods side by side. */
    public VisibilityChoice comparing(String scene, String method, String other) {
        return withScene(scene).withVisibility(method).withComparison(other);
    }

    /** The choice in the scene's own colours, unmarked. */
    public VisibilityChoice inOwnColors() {
        return withShading(OWN_COLORS).withDifference(false);
    }

    public VisibilityChoice withComparison(String other) {
        var draft = new Draft(this);
        draft.comparison = other;
        draft.least = least.with(false);
        return draft.choice();
    }

    public VisibilityChoice withShading(String other) {
        var draft = new Draft(this);
        draft.shading = other;
        draft.least = least.with(false);
        return draft.choice();
    }

    /** This choice in the scene's own colours, where the vase's greys are chosen. */
    VisibilityChoice inColors() {
        return shading.equals(VASE_TONES) ? withShading(OWN_COLORS) : this;
    }

    public VisibilityChoice withProjection(String other) {
        var draft = new Draft(this);
        draft.projection = other;
        return draft.choice();
    }

    public VisibilityChoice withCamera(SphericalView other) {
        var draft = new Draft(this);
        draft.camera = other;
        return draft.choice();
    }

    public VisibilityChoice withEdges(boolean drawn) {
        var draft = new Draft(this);
        draft.edges = drawn;
        draft.least = least.with(false);
        return draft.choice();
    }

    public VisibilityChoice withDifference(boolean marked) {
        var draft = new Draft(this);
        draft.difference = marked;
        draft.least = least.with(false);
        return draft.choice();
    }

    public VisibilityChoice withView(StageView other) {
        var draft = new Draft(this);
        draft.view = other;
        draft.least = least.with(false);
        return draft.choice();
    }

    public VisibilityChoice withDrawing(boolean stepped) {
        var draft = new Draft(this);
        draft.drawing = stepped;
        draft.least = least.with(false);
        return draft.choice();
    }

    public VisibilityChoice with(LookChoice other) {
        var draft = new Draft(this);
        draft.look = suited(other, shown);
        return draft.choice();
    }

    /**
     * Draws the least picture that is enough, or the method's again. There is one picture then, in
     * its colours, to its end; whoever chooses another gets the method's.
     */
    public VisibilityChoice with(PlanWish wish) {
        var draft = new Draft(this);
        draft.least = wish;
        if (wish.on()) {
            draft.comparison = "";
            draft.edges = false;
            draft.difference = false;
            draft.view = StageView.COLORS;
            draft.drawing = false;
        }
        return draft.choice();
    }

    /**
     * The tolerance of the least picture, where it is drawn; empty where it is not: a plan is for
     * faces, and for one eye.
     */
    public Optional<Tolerance> tolerance() {
        boolean faces = !shading.equals("wire") && look.stereo().isEmpty();
        return faces ? least.tolerance() : Optional.empty();
    }

    /**
     * A method as the terminal knows it: what suits the scene stands for the user's own program.
     */
    public static String known(String method) {
        return method.equals(OwnMethods.NAME) ? Renderer.AUTO : method;
    }

    /**
     * The picture without edges, which are no matter of visibility. The user's own program has no
     * name there: whoever has it gives it to the request.
     */
    public RenderRequest plain(int width, int height) {
        return plain(visibility, width, height);
    }

    /** The request for another method. */
    public RenderRequest plain(String method, int width, int height) {
        Scene zoomed = look.change().of(shown.scene().zoomed(zoom));
        Projection chosen = Projection.named(projection);
        return new RenderRequest(
                zoomed,
                camera,
                chosen,
                look.depths(chosen, camera.rho()),
                width,
                height,
                look.look(known(method), ShadingMethod.named(shading), chosen, camera.rho()));
    }

    /** Parts of a choice, to be changed one by one. */
    private static final class Draft {
        private SceneChoice shown;
        private String visibility;
        private String comparison;
        private String shading;
        private String projection;
        private SphericalView camera;
        private double zoom;
        private boolean edges;
        private boolean difference;
        private StageView view;
        private boolean drawing;
        private LookChoice look;
        private PlanWish least;

        Draft(VisibilityChoice from) {
            shown = from.shown;
            visibility = from.visibility;
            comparison = from.comparison;
            shading = from.shading;
            projection = from.projection;
            camera = from.camera;
            zoom = from.zoom;
            edges = from.edges;
            difference = from.difference;
            view = from.view;
            drawing = from.drawing;
            look = from.look;
            least = from.least;
        }

        VisibilityChoice choice() {
            return new VisibilityChoice(
                    shown,
                    visibility,
                    comparison,
                    shading,
                    projection,
                    camera,
                    zoom,
                    edges,
                    difference,
                    view,
                    drawing,
                    look,
                    least);
        }
    }
}
