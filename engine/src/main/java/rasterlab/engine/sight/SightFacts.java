package rasterlab.engine.sight;

import java.util.Optional;
import java.util.function.Supplier;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.painter.ConvexBody;
import rasterlab.engine.visibility.ray.FaceCrossings;
import rasterlab.engine.visibility.ray.SharedPlanes;

/**
 * The facts that hold for a scene's faces wherever they are seen from; each fact is found when it
 * is first asked for, and kept.
 */
public final class SightFacts {
    /** A mesh of more faces is not searched face against face. */
    public static final int FEW_FACES = 300;

    private final Scene scene;
    private final Mesh mesh;
    private Optional<Boolean> convex = Optional.empty();
    private Optional<Boolean> closed = Optional.empty();
    private Optional<Boolean> overlap = Optional.empty();
    private Optional<Boolean> crossing = Optional.empty();
    private Optional<Double> separation = Optional.empty();
    private Optional<Double> radius = Optional.empty();
    private final boolean glass;

    public SightFacts(Scene scene) {
        this.scene = scene;
        mesh = scene.mesh();
        glass = scene.finishes().stream().anyMatch(SightFacts::seenThrough);
    }

    /** Whether these are the facts of a scene. */
    public boolean of(Scene other) {
        return other.mesh() == mesh
                && other.finishes().equals(scene.finishes())
                && other.surfaces().isPresent() == scene.surfaces().isPresent();
    }

    private static boolean seenThrough(Appearance finish) {
        return finish.front().alpha() < 1
                || finish.back().alpha() < 1
                || !finish.texture().map(laid -> laid.opaque()).orElse(true);
    }

    /** Whether something may be seen through a face. */
    public boolean glass() {
        return glass;
    }

    public boolean few() {
        return mesh.faceCount() <= FEW_FACES;
    }

    /** Whether the mesh is one convex closed body; false where it has too many faces to know. */
    public synchronized boolean convex() {
        if (convex.isEmpty()) convex = Optional.of(few() && ConvexBody.flaw(mesh).isEmpty());
        return convex.get();
    }

    /**
     * Whether faces that show their backs are hidden from every place outside: the mesh is closed,
     * and it stands for surfaces whose fronts are outside, or is convex.
     */
    public synchronized boolean closed() {
        if (closed.isEmpty())
            closed =
                    Optional.of(
                            !glass
                                    && (scene.surfaces().isPresent() || convex())
                                    && ClosedMesh.is(mesh)
                                    && ClosedMesh.volume(mesh) > 0);
        return closed.get();
    }

    /**
     * Whether faces lie over each other in one plane; false where there are too many to know.
     *
     * @param view any view of the mesh, asked for once at most
     */
    public synchronized boolean overlap(Supplier<ViewedMesh> view) {
        if (overlap.isEmpty()) overlap = Optional.of(few() && SharedPlanes.anyOverlap(view.get()));
        return overlap.get();
    }

    /**
     * Whether faces pass through each other; false where there are too many to know.
     *
     * @param view any view of the mesh, asked for once at most
     */
    public synchronized boolean crossing(Supplier<ViewedMesh> view) {
        if (crossing.isEmpty())
            crossing = Optional.of(few() && !FaceCrossings.of(view.get(), () -> false).isEmpty());
        return crossing.get();
    }

    /**
     * The smallest distance in space between two faces, in world units; 0 where some touch, or
     * where there are too many to know. Along every line of sight they are at least as far apart.
     */
    public synchronized double separation() {
        if (separation.isEmpty()) separation = Optional.of(few() ? FaceGaps.least(mesh) : 0);
        return separation.get();
    }

    /** The distance of the mesh's farthest corner from the origin, which cameras turn about. */
    public synchronized double radius() {
        if (radius.isEmpty()) {
            double most = 0;
            for (int v = 0; v < mesh.vertexCount(); v++)
                most = Math.max(most, Math.hypot(Math.hypot(mesh.x(v), mesh.y(v)), mesh.z(v)));
            radius = Optional.of(most);
        }
        return radius.get();
    }
}
