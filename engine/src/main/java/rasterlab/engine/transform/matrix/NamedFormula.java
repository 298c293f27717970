package rasterlab.engine.transform.matrix;

import rasterlab.contract.MatrixFormula;

/** Every matrix by its right formula. */
public final class NamedFormula implements MatrixFormula {
    @Override
    public double[][] rows(String name, double... parameters) {
        return NamedMatrices.named(name).rows(parameters);
    }
}
