package rasterlab.engine.light.normals;

import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.study.Workload;

/** Spheres of meridians and parallels, coarse to fine. */
final class NormalsWorkloads {
    private NormalsWorkloads() {}

    static List<Workload<TriangleSurface>> all() {
        var workloads = new ArrayList<Workload<TriangleSurface>>();
        for (int parallels : new int[] {4, 12, 36}) {
            TriangleSurface sphere = sphere(2 * parallels, parallels);
            int vertices = sphere.vertices().length / 3;
            workloads.add(new Workload<>("sphere-" + vertices, vertices, List.of(sphere)));
        }
        return workloads;
    }

    /**
     * A sphere of radius 1 about the origin: vertices row by row from the lower pole, which like
     * the upper one is a single vertex.
     *
     * @param meridians at least 3
     * @param parallels rows of faces, at least 2
     */
    static TriangleSurface sphere(int meridians, int parallels) {
        var vertices = new double[3 * (2 + meridians * (parallels - 1))];
        vertices[2] = -1;
        vertices[vertices.length - 1] = 1;
        for (int row = 1, at = 3; row < parallels; row++)
            for (int column = 0; column < meridians; column++, at += 3) {
                double up = Math.PI * row / parallels;
                double around = 2 * Math.PI * column / meridians;
                vertices[at] = Math.sin(up) * Math.cos(around);
                vertices[at + 1] = Math.sin(up) * Math.sin(around);
                vertices[at + 2] = -Math.cos(up);
            }
        var triangles = new ArrayList<Integer>();
        int top = vertices.length / 3 - 1;
        for (int column = 0; column < meridians; column++) {
            int next = (column + 1) % meridians;
            triangles.addAll(List.of(0, 1 + next, 1 + column));
            int last = 1 + (parallels - 2) * meridians;
            triangles.addAll(List.of(top, last + column, last + next));
            for (int row = 0; row < parallels - 2; row++) {
                int here = 1 + row * meridians;
                int above = here + meridians;
                triangles.addAll(List.of(here + column, here + next, above + next));
                triangles.addAll(List.of(here + column, above + next, above + column));
            }
        }
        return new TriangleSurface(
                vertices, triangles.stream().mapToInt(Integer::intValue).toArray());
    }
}
