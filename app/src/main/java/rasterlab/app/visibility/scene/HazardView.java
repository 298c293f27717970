package rasterlab.app.visibility.scene;

import java.util.Locale;
import java.util.function.UnaryOperator;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.transform.SphericalView;

/** Views that show how visibility methods work, and three on which one fails. */
public enum HazardView {
    /** The view in which the vase's author shows it. */
    COURSEWORK("vase", "painter", Math.PI / 9, 4 * Math.PI / 3, 1, 1.6, false),
    /** Inner faces show through the vase's opening. */
    OPENING("vase", "painter", Math.PI / 9, 0.2 * Math.PI, 1, 1.6, false),
    /** The coursework's rounded coordinates move edges, here of the vase. */
    ROUNDED("vase", "painter-textbook", 0, 1.45 * Math.PI, 1, 1.6, true),
    /** Three of four corners make a wrong mean, here of the house. */
    THREE_CORNERS("house", "painter-textbook", 0.95 * Math.PI, 1.15 * Math.PI, 0.5, 1, true),
    /** The right mean still misorders: a large face beside a small one. */
    MEAN("house", "painter", 0.45 * Math.PI, 0.85 * Math.PI, 0.5, 1, true),
    /** The vase's rings, level with the eye, shrink to lines: hardly anything is wrong. */
    EDGE_ON("vase", "painter", 0, Math.PI / 2, 1, 1.6, true),
    /** Each board lies before the next one in a circle: no order of whole faces is right. */
    CYCLIC("cyclic-overlap", "painter"),
    /** Bodies that pierce each other. */
    PIERCING("interpenetrating", "painter"),
    /** Sheets in one plane: what is seen depends on their order alone. */
    COPLANAR("coplanar", "painter"),
    /** Sixteen bits cannot tell sheets apart that nearly coincide. */
    COARSE("coplanar", "z16");

    private final String scene;
    private final String method;
    private final UnaryOperator<SphericalView> camera;
    private final double zoom;
    private final boolean difference;
    private final boolean colored;

    /**
     * @param theta radians
     * @param phi radians
     * @param zoom as in {@link VisibilityChoice}
     * @param nearness ρ as a share of the scene's first one
     */
    HazardView(
            String scene,
            String method,
            double theta,
            double phi,
            double nearness,
            double zoom,
            boolean difference) {
        this(
                scene,
                method,
                first -> new SphericalView(theta, phi, nearness * first.rho()),
                zoom,
                difference,
                false);
    }

    /**
     * The scene as it is first seen, with what is wrong in it; bodies need colours of their own.
     */
    HazardView(String scene, String method) {
        this(scene, method, first -> first, 1, true, true);
    }

    /**
     * @param camera what becomes of the scene's first one; asked when the view is shown, for scenes
     *     take long to make
     * @param colored whether the scene has bodies of several colours
     */
    HazardView(
            String scene,
            String method,
            UnaryOperator<SphericalView> camera,
            double zoom,
            boolean difference,
            boolean colored) {
        this.scene = scene;
        this.method = method;
        this.camera = camera;
        this.zoom = zoom;
        this.difference = difference;
        this.colored = colored;
    }

    /** Lower-case name with hyphens, part of keys and component names. */
    public String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** The choice that shows this view; projection stays, and shading that tells bodies apart. */
    public VisibilityChoice shown(VisibilityChoice choice) {
        VisibilityChoice other = choice.withScene(scene);
        if (colored) other = other.inColors();
        return other.with(LookChoice.USUAL)
                .withView(StageView.COLORS)
                .withVisibility(method)
                .zoomed(zoom / other.zoom())
                .withCamera(camera.apply(Scenes.named(scene).defaultCamera()))
                .withDifference(difference);
    }
}
