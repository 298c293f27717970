package rasterlab.app.exercise;

import static rasterlab.app.exercise.BackgroundWork.Phase.JOINING;

import java.io.IOException;
import java.net.URI;
import java.util.Optional;
import rasterlab.app.exercise.JoinAnswer.JoinField;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.app.server.Account;
import rasterlab.app.server.CourseServer;
import rasterlab.app.server.ServerRefusal;

/** Makes the account that sources are handed in with: by a course's code, or by a token. */
public final class Enrolment {
    /** How somebody comes to an account: by a course's code, or by a token. */
    private interface Joining {
        /**
         * @throws ServerRefusal if the server does not know the code or the token
         */
        Account with(CourseServer server) throws IOException, InterruptedException;
    }

    private final ExerciseLabModel model;
    private final CourseServer.ServerTimeouts patience;

    Enrolment(ExerciseLabModel model, CourseServer.ServerTimeouts patience) {
        this.model = model;
        this.patience = patience;
    }

    /** Forgets the answer to an earlier form. */
    public void askForCourse() {
        model.publish(model.changed().joining(JoinAnswer.NONE));
    }

    /**
     * Joins a course, to submit to it from now on.
     *
     * @param address of the server
     * @param code of the course
     * @param name of the student
     */
    public void join(String address, String code, String name) {
        String key = model.key(address + "\n" + code + "\n" + name);
        server(address).ifPresent(at -> join(at, course -> course.join(code, name, key)));
    }

    /** Submits with a token that the student has already, if the server knows it. */
    public void signIn(String address, String token) {
        server(address).ifPresent(server -> join(server, course -> course.known(token.strip())));
    }

    private Optional<URI> server(String address) {
        try {
            return Optional.of(Account.server(address));
        } catch (IllegalArgumentException e) {
            accept(JoinAnswer.refused(JoinField.ADDRESS, Notice.of("server.address", address)));
            return Optional.empty();
        }
    }

    private void join(URI server, Joining joining) {
        model.begin(
                BackgroundWork.of(JOINING),
                tell -> {
                    var account = joining.with(new CourseServer(server, patience));
                    return () -> use(account);
                },
                failure -> accept(ServerNotices.joining(server, failure)));
    }

    private void accept(JoinAnswer refused) {
        model.publish(model.changed().joining(refused).notice(refused.problem()));
    }

    private void use(Account account) {
        Notice notice =
                model.folder()
                        .flatMap(kept -> new AccountFile(kept).unsaved(account))
                        .orElse(Notice.of("joined", account.toString()));
        var joined = model.changed().account(Optional.of(account)).joining(JoinAnswer.JOINED);
        model.publish(joined.notice(notice));
    }
}
