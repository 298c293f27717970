package rasterlab.app.cli.exercise;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rasterlab.app.cli.console.Console;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.proving.Proof;
import rasterlab.exercises.runner.Judge;
import rasterlab.exercises.runner.JudgeSettings;
import rasterlab.exercises.runner.JudgeSettings.Speed;

/** Proves exercises. */
@Command(
        name = "prove",
        mixinStandardHelpOptions = true,
        description = {
            "Proves that exercises tell right programs from wrong ones.",
            "Right methods and the model solution must keep all points, the starter must earn next to",
            "nothing, and a case must reject and name each faulty method and mutant. Prints what rejected",
            "which. Several are proved in parallel, without the speed of the model solution.",
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:every exercise is proved",
            "1:something speaks against one; it stands below its table",
            "2:no such exercise, or the folder cannot be read",
        },
        footer = {"", "Example: ./lab exercises prove point-in-polygon"})
final class ExercisesProveCommand implements Callable<Integer> {
    /** The seed of generated cases; it is fixed, so that a proof can be repeated. */
    private static final long SEED = 20261127;

    private final Console console;

    @Parameters(arity = "0..*", paramLabel = "ID", description = "only these; default: all")
    private List<String> ids = List.of();

    @Option(names = "--json", description = "prints one JSON object instead of tables")
    private boolean json;

    @Option(
            names = "--seed",
            paramLabel = "N",
            description = "draws the generated cases; default: ${DEFAULT-VALUE}")
    private long seed = SEED;

    @Mixin private ExercisesOption exercises;

    ExercisesProveCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException {
        List<Proof> proofs = proofs(chosen());
        if (json) ProofJson.write(proofs, console.out(), console.language().code());
        else if (proofs.size() > 1) ProofText.printSummary(proofs, console);
        boolean proved = proofs.stream().allMatch(one -> one.faults().isEmpty());
        return proved ? ExitCode.DONE : ExitCode.FOUND_WRONG;
    }

    private List<Exercise> chosen() {
        Catalogue catalogue = exercises.catalogue(console);
        if (ids.isEmpty()) return catalogue.all();
        return ids.stream().map(id -> ExercisesOption.named(id, catalogue)).toList();
    }

    private List<Proof> proofs(List<Exercise> chosen) {
        try (Judge judge = Judge.start(settings(chosen.size()));
                var pool = new ProofPool(judge, seed, this::begun)) {
            List<Proof> proofs = new ArrayList<>();
            for (Future<Proof> one : pool.proofs(chosen)) {
                proofs.add(one.get());
                if (!json) ProofText.print(proofs.get(proofs.size() - 1), console);
            }
            return proofs;
        } catch (ExecutionException failed) {
            throw cause(failed);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw Complaint.gaveUp("interrupted");
        }
    }

    /** Returns or throws what ended a proof, as if it had been tried here. */
    private static RuntimeException cause(ExecutionException failed) {
        if (failed.getCause() instanceof Error error) throw error;
        return failed.getCause() instanceof RuntimeException cause
                ? cause
                : new IllegalStateException(failed.getCause());
    }

    /** One exercise has the machine to itself; beside others no speed could be settled. */
    private static JudgeSettings settings(int exercises) {
        return JudgeSettings.once().withSpeed(exercises == 1 ? Speed.MEASURED : Speed.ONCE);
    }

    private synchronized void begun(Exercise one, int place, int of) {
        console.tell("proving", one.id(), place, of);
    }
}
