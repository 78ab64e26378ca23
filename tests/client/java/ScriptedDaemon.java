import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;

/** A daemon that says what a test tells it to. One client at a time. */
final class ScriptedDaemon implements AutoCloseable {
    private final int port;
    private ServerSocket server;
    private Socket client;
    private BufferedReader lines;
    private OutputStream out;

    ScriptedDaemon() throws IOException {
        server = new ServerSocket(0, 8, InetAddress.getByName("127.0.0.1"));
        port = server.getLocalPort();
    }

    String address() {
        return "127.0.0.1:" + port;
    }

    /** Waits for a client and greets it, as a daemon without keys. */
    ScriptedDaemon greet() throws IOException {
        return greet("");
    }

    /** Waits for a client and greets it, with so much more in the answer, as {@code " keys=yes sealing=encrypted"}. */
    ScriptedDaemon greet(String more) throws IOException {
        client = server.accept();
        client.setTcpNoDelay(true);
        lines = new BufferedReader(new InputStreamReader(client.getInputStream(), StandardCharsets.UTF_8));
        out = client.getOutputStream();
        Check.equal("0 sys hello name=test keys=yes", heard());
        say("0 msg hello version=1 participant=5e6f7a8b peer=1 name=test ontology=0 participant_name=host" + more);
        return this;
    }

    /** Greets, and takes whatever is stated, while the test waits for it. */
    void greetInBackground() {
        Thread thread = new Thread(() -> {
            try {
                greet();
                for (String line = heard(); line != null; line = heard()) {
                    if (line.equals("0 sys ping")) say("0 msg pong");
                }
            } catch (IOException isOver) {
                return;
            }
        });
        thread.setDaemon(true);
        thread.start();
    }

    /** The next line of the client. */
    String heard() throws IOException {
        return lines.readLine();
    }

    /** The next lines must be a create and a ping, which is answered; the create. */
    String takes() throws IOException {
        String create = heard();
        Check.equal("0 sys ping", heard());
        say("0 msg pong");
        return create;
    }

    ScriptedDaemon say(String line) throws IOException {
        out.write((line + "\r\n").getBytes(StandardCharsets.UTF_8));
        return this;
    }

    /** As kill -9: the port is closed, too. */
    void die() throws IOException {
        server.close();
        if (client != null) client.close();
    }

    void comeBack() throws IOException {
        server = new ServerSocket();
        server.setReuseAddress(true);
        server.bind(new java.net.InetSocketAddress("127.0.0.1", port));
    }

    /** Tells of a provider at a port of this host. */
    static String provider(long number, String word, int port, String protocol, String life, String more) {
        return number + " pub add service=" + word + " provider=5e6f7a8b/2 name=p text=x degree=exact distance=0 mode=oto address=127.0.0.1 port=" + port + " protocol=" + protocol
                + " priority=0" + more + (life.isEmpty() ? "" : " channel=" + life);
    }

    /** Tells of a consumer at a port of this host. */
    static String consumer(long number, String word, int port, String life) {
        return number + " sub add subscription=" + word + " consumer=5e6f7a8b/3 name=c text=x degree=exact distance=0 mode=oto address=127.0.0.1 port=" + port + " priority=0 channel=" + life;
    }

    @Override
    public void close() throws IOException {
        die();
    }
}
