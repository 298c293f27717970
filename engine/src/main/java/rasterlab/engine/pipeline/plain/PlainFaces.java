package rasterlab.engine.pipeline.plain;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.joml.Vector4d;
import rasterlab.engine.scene.FaceMiddle;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.ViewedMesh;

/** The faces that are drawn: their order, their corners and what cuts them in the world. */
final class PlainFaces {
    private PlainFaces() {}

    /** Opaque faces come as they are listed; what is seen through comes last, farthest first. */
    static List<Integer> transparentLast(ViewedMesh view, FacePaint paint) {
        Comparator<Integer> opaque = Comparator.comparing(paint::opaque);
        Comparator<Integer> depth =
                Comparator.comparingDouble(
                        f -> paint.opaque(f) ? 0 : FaceMiddle.of(view.mesh(), f, view::eyeZ));
        return IntStream.range(0, view.mesh().faceCount())
                .boxed()
                .sorted(opaque.thenComparing(depth).reversed())
                .toList();
    }

    static List<Vector4d> corners(Mesh mesh, int face) {
        var corners = new ArrayList<Vector4d>();
        for (int k = 0; k < mesh.cornerCount(face); k++) {
            int vertex = mesh.corner(face, k);
            corners.add(new Vector4d(mesh.x(vertex), mesh.y(vertex), mesh.z(vertex), 1));
        }
        return corners;
    }

    /** Planes (a, b, c, d) with a·x + b·y + c·z + d ≥ 0 where it is drawn. */
    static List<Vector4d> worldPlanes(ViewedMesh view) {
        return view.clipPlanes().stream()
                .map(plane -> new Vector4d(plane.a(), plane.b(), plane.c(), plane.d()))
                .toList();
    }
}
