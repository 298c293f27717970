package rasterlab.engine.sight;

import java.util.Optional;
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
    private final boolean glass;

    public SightFacts(Scene scene) {
        this.scene = scene;
        mesh = scene.mesh();
        glass = scene.finishes().stream().anyMatch(SightFacts::seenThrough);
    }

    /** Whether these are the facts of a scene. */
    public boolean of(Scene other) {
        return other.mesh() == mesh && other.finishes().equals(scene.finishes());
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
     * @param view any view of the mesh
     */
    public synchronized boolean overlap(ViewedMesh view) {
        if (overlap.isEmpty()) overlap = Optional.of(few() && SharedPlanes.anyOverlap(view));
        return overlap.get();
    }

    /** Whether faces pass through each other; false where there are too many to know. */
    public synchronized boolean crossing(ViewedMesh view) {
        if (crossing.isEmpty())
            crossing = Optional.of(few() && !FaceCrossings.of(view, () -> false).isEmpty());
        return crossing.get();
    }
}
