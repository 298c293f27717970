package rasterlab.app.light;

import java.util.List;
import java.util.Optional;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.Substance;
import rasterlab.engine.scene.Appearance;

/** The material of a scene file as one that the lab makes of its substances. */
final class MaterialOfFile {
    private MaterialOfFile() {}

    /**
     * The material; empty where faces differ, are glass, or are of no substance that the lab has.
     */
    static Optional<MaterialChoice> of(List<Appearance> finishes) {
        if (finishes.size() != 1) return Optional.empty();
        Appearance one = finishes.get(0);
        if (one.front() != one.back() || one.front().alpha() < 1) return Optional.empty();
        for (Substance substance : Substance.values()) {
            Optional<MaterialChoice> found = of(substance, one.front().surface());
            if (found.isPresent()) return found;
        }
        return Optional.empty();
    }

    private static Optional<MaterialChoice> of(Substance substance, SurfaceMaterial wanted) {
        SurfaceMaterial whole = substance.surface();
        double ambient = factor(whole.ambient(), wanted.ambient());
        double diffuse = factor(whole.diffuse(), wanted.diffuse());
        double specular = factor(whole.specular(), wanted.specular());
        double emission = factor(whole.diffuse(), wanted.emission());
        double most = MaterialChoice.MOST;
        boolean within = ambient <= most && diffuse <= most && specular <= most && emission <= 1;
        if (!within || wanted.shininess() > MaterialChoice.SHINIEST) return Optional.empty();
        var choice =
                new MaterialChoice(
                        substance, ambient, diffuse, specular, emission, wanted.shininess());
        SurfaceMaterial made = choice.material().surface();
        boolean same =
                same(made.ambient(), wanted.ambient())
                        && same(made.diffuse(), wanted.diffuse())
                        && same(made.specular(), wanted.specular())
                        && same(made.emission(), wanted.emission());
        return same ? Optional.of(choice) : Optional.empty();
    }

    /** Shares stop at 1, so that the largest factor is the one. */
    private static double factor(double[] whole, double[] wanted) {
        double factor = 0;
        for (int c = 0; c < 3; c++)
            if (whole[c] > 0) factor = Math.max(factor, wanted[c] / whole[c]);
        return factor;
    }

    private static boolean same(double[] one, double[] other) {
        for (int c = 0; c < 3; c++) if (!LampsOfFile.same(one[c], other[c])) return false;
        return true;
    }
}
