package rasterlab.app.coordinates.list;

import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import rasterlab.app.coordinates.figure.CallJson;
import rasterlab.contract.PointTransformer;
import rasterlab.engine.transform.Images;
import rasterlab.engine.transform.chain.Chain;
import rasterlab.engine.transform.chain.TransformTopic;

/** Points through matrices. */
final class ChainTrial extends TrialKind<PointTransformer, Chain, TransformTopic.Output> {
    ChainTrial() {
        super(new TransformTopic(), new TrialTexts("coordinates.view", ""));
    }

    @Override
    PointList list(Chain chain) {
        return PointList.of(chain);
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

    @Override
    String json(Chain chain) {
        String matrices =
                Stream.of(chain.matrices())
                        .map(cells -> CallJson.rows(4, cells))
                        .collect(Collectors.joining(", ", "[", "]"));
        return "{\"matrices\": %s, \"points\": %s}".formatted(matrices, points(chain));
    }

    private static String points(Chain chain) {
        if (DoubleStream.of(chain.h()).allMatch(h -> h == 1))
            return CallJson.points(3, chain.points());
        var homogeneous = new double[4 * chain.h().length];
        for (int i = 0; i < chain.h().length; i++) {
            System.arraycopy(chain.points(), 3 * i, homogeneous, 4 * i, 3);
            homogeneous[4 * i + 3] = chain.h()[i];
        }
        return CallJson.points(4, homogeneous);
    }
}
