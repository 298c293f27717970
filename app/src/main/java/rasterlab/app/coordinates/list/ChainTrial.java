package rasterlab.app.coordinates.list;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Optional;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.PointTransformer;
import rasterlab.engine.transform.Images;
import rasterlab.engine.transform.chain.Chain;
import rasterlab.engine.transform.chain.TransformTopic;

/** Points through matrices. */
final class ChainTrial extends TrialKind<PointTransformer, Chain, TransformTopic.Output> {
    ChainTrial(OwnMethods own) {
        super(own.in(new TransformTopic()));
    }

    @Override
    PointList list(Chain chain) {
        return PointList.of(chain);
    }

    /** {@inheritDoc} Matrices that are refused are none. */
    @Override
    Optional<Chain> listed(ListScene scene) {
        if (scene.isRefused()) return Optional.empty();
        var matrices = new ArrayList<>(scene.cells());
        Collections.reverse(matrices);
        return Optional.of(
                new Chain(
                        scene.choice().dimension(),
                        matrices.toArray(double[][]::new),
                        scene.choice().coordinates()));
    }

    @Override
    Images images(TransformTopic.Output output) {
        return output.images();
    }

    @Override
    Optional<double[]> h(TransformTopic.Output output) {
        return Optional.of(output.h());
    }

    @Override
    Chain only(Chain chain, int point) {
        return new Chain(
                chain.dimension(),
                chain.matrices(),
                xyz(chain.points(), point),
                new double[] {chain.h()[point]});
    }

    @Override
    TransformTopic.Output outputOf(TransformTopic.Output output, int point) {
        return new TransformTopic.Output(
                new Images(xyz(output.images().coordinates(), point), 3),
                new double[] {output.h()[point]});
    }
}
