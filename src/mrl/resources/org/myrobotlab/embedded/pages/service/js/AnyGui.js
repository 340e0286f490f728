// Panel of a service without its own: its state.
angular.module('mrlapp.service.AnyGui', []).controller('AnyGuiCtrl', ['$scope', function($scope) {
    const msg = this.msg

    this.onMsg = function(inMsg) {
        if (inMsg.method === 'onState') {
            $scope.service = inMsg.data[0]
            $scope.$apply()
        }
    }
    $scope.releaseService = function() {
        msg.sendTo('runtime', 'release', msg.name)
    }
    msg.subscribe(this)
}])
