package rasterlab.engine.scene.obj;

import java.util.Arrays;
import rasterlab.engine.scene.TriangleMesh;

/** The triangles of one material: faces as fans over vertices that equal corners share. */
final class PartBuilder {
    private static final int POSITION = 0;
    private static final int PLACE = 1;
    private static final int NORMAL = 2;

    private final Faces faces;
    private final CornerTable corners = new CornerTable();
    private final Ints triangles = new Ints();
    private boolean textured;

    PartBuilder(Faces faces) {
        this.faces = faces;
    }

    void add(int face) {
        for (int k = 1; k + 1 < faces.corners(face); k++) {
            triangles.add(vertex(face, 0));
            triangles.add(vertex(face, k));
            triangles.add(vertex(face, k + 1));
        }
    }

    private int vertex(int face, int corner) {
        int place = faces.texture(face, corner);
        textured |= place != Faces.NONE;
        return corners.number(faces.vertex(face, corner), place, faces.normal(face, corner));
    }

    TriangleMesh mesh(double[] positions, double[] colors, double[] places, double[] normals) {
        var mesh =
                TriangleMesh.of(
                                column(positions, 3, 0, POSITION),
                                column(positions, 3, 1, POSITION),
                                column(positions, 3, 2, POSITION),
                                triangles.all())
                        .withNormals(
                                column(normals, 3, 0, NORMAL),
                                column(normals, 3, 1, NORMAL),
                                column(normals, 3, 2, NORMAL));
        if (textured)
            mesh = mesh.withTexture(column(places, 2, 0, PLACE), column(places, 2, 1, PLACE));
        return colors.length == 0 ? mesh : colored(mesh, colors);
    }

    private TriangleMesh colored(TriangleMesh mesh, double[] colors) {
        float[] opaque = new float[corners.size()];
        Arrays.fill(opaque, 1);
        return mesh.withColors(
                column(colors, 3, 0, POSITION),
                column(colors, 3, 1, POSITION),
                column(colors, 3, 2, POSITION),
                opaque);
    }

    /** Number {@code at} of {@code width} of what each corner names; 0 where it names none. */
    private float[] column(double[] values, int width, int at, int item) {
        float[] column = new float[corners.size()];
        for (int v = 0; v < column.length; v++) {
            int number = corners.get(v, item);
            if (number != Faces.NONE) column[v] = (float) values[width * number + at];
        }
        return column;
    }
}
