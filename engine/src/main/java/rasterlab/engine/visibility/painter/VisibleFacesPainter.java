package rasterlab.engine.visibility.painter;

import java.util.stream.IntStream;
import rasterlab.contract.VisibleFaces;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.study.WrongLength;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.SteppedVisibility;
import rasterlab.engine.visibility.Tally;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.VisibilityWalk;

/**
 * Draws the faces that a method of topic {@code visible-faces} calls visible, in the order of the
 * mesh. The method is asked once for a picture, about the whole mesh as it stands in the world.
 */
public final class VisibleFacesPainter implements SteppedVisibility {
    private static final double[] NO_INNER_POINT = {};

    private final VisibleFaces method;

    public VisibleFacesPainter(VisibleFaces method) {
        this.method = method;
    }

    @Override
    public boolean drawsOutlines() {
        return true;
    }

    @Override
    public String decision() {
        return "n·p; right methods call a face visible where it is below 0";
    }

    /**
     * @throws IllegalArgumentException in parallel projection, whose eye is nowhere; also with the
     *     method's own words
     * @throws WrongLength if it answers for more or fewer faces
     */
    @Override
    public VisibilityWalk walk(ViewedMesh view, FacePaint paint, Raster out) {
        if (!view.transform().central())
            throw new IllegalArgumentException(
                    "the projection must be perspective for a method that is told where the eye"
                            + " is, got a parallel one");
        boolean[] visible = visible(view);
        var tally = new Tally();
        tally.comparisons = visible.length;
        int[] order = IntStream.range(0, visible.length).filter(face -> visible[face]).toArray();
        return new FaceSequence(view, order, BackFaceCulling.facing(view), tally, paint, out);
    }

    private boolean[] visible(ViewedMesh view) {
        Mesh mesh = view.mesh();
        var xyz = new double[3 * mesh.vertexCount()];
        for (int v = 0; v < mesh.vertexCount(); v++) {
            xyz[3 * v] = mesh.x(v);
            xyz[3 * v + 1] = mesh.y(v);
            xyz[3 * v + 2] = mesh.z(v);
        }
        var faces = new int[mesh.faceCount()][];
        for (int f = 0; f < faces.length; f++) {
            int face = f;
            faces[f] =
                    IntStream.range(0, mesh.cornerCount(f))
                            .map(corner -> mesh.corner(face, corner))
                            .toArray();
        }
        var eye = new double[3];
        for (int axis = 0; axis < 3; axis++) eye[axis] = view.transform().toWorld(axis, 0, 0, 0);
        boolean[] visible = method.visible(xyz, faces, eye, NO_INNER_POINT);
        WrongLength.require(faces.length, visible.length, "faces");
        return visible;
    }
}
