package rasterlab.engine.light.normals;

import java.util.List;
import rasterlab.contract.VertexNormals;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods of the topic, in teaching order. */
final class NormalsMethods {
    private NormalsMethods() {}

    static List<Method<VertexNormals>> all() {
        return List.of(
                method(
                        "plain-textbook",
                        "n = (n₁ + … + n_k)/k, as described: not brought to length 1",
                        "none; the mean of unit vectors is shorter than 1",
                        "1 square root per face",
                        "zero-area faces (0/0), curved surfaces (short normals), every cut of a"
                                + " flat face",
                        "student's coursework: three-dimensional model of a vase, section 2.2",
                        new SummedNormals()),
                method(
                        "plain",
                        "n = Σ nᵢ, brought to length 1",
                        "length 1, or no normal at all",
                        "1 square root per face, 1 per vertex",
                        "depends on how flat faces are cut into triangles",
                        "H. Gouraud, Continuous shading of curved surfaces, IEEE Transactions on"
                                + " Computers 20(6), 1971",
                        new WeightedNormals(Weight.PLAIN)),
                method(
                        "area",
                        "n = Σ Aᵢ·nᵢ, the sum of the cross products, brought to length 1",
                        "length 1, or no normal at all",
                        "1 square root per face, 1 per vertex",
                        "large faces outvote small ones, however narrow they are at the vertex",
                        "student's coursework: three-dimensional model of a vase, section 2.2"
                                + " (as what happens without normalising)",
                        new WeightedNormals(Weight.AREA)),
                method(
                        "angle",
                        "n = Σ αᵢ·nᵢ, αᵢ the face's angle at the vertex, brought to length 1",
                        "length 1, or no normal at all; cutting flat faces changes nothing",
                        "3 arctangents and 7 square roots per face, 1 per vertex",
                        "none known where no face is narrower than a thousandth of its sides, no"
                                + " side shorter than that of its coordinates, and a vertex's faces"
                                + " do not cancel to less",
                        "G. Thürmer, C. A. Wüthrich, Computing vertex normals from polygonal"
                                + " facets, Journal of Graphics Tools 3(1), 1998",
                        new WeightedNormals(Weight.ANGLE)));
    }

    private static Method<VertexNormals> method(
            String name,
            String formula,
            String invariant,
            String cost,
            String failures,
            String source,
            VertexNormals implementation) {
        return new Method<>(
                name, new About(formula, invariant, cost, failures, source), implementation);
    }
}
